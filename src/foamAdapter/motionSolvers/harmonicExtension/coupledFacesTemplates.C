// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupledFaces.H"
#include "cyclicPolyPatch.H"
#include "processorPolyPatch.H"
#include "UIPstream.H"
#include "UOPstream.H"

#include <algorithm>

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<class Type>
Foam::List<Type> Foam::coupledFaces::beyond(const List<Type>& own) const
{
    static_assert(is_contiguous<Type>::value, "copied by bytes");

    List<Type> other(own.size());
    const label nRequests = UPstream::nRequests();
    for (const polyPatch& patch : patches_)
    {
        const label start = starts_[patch.index()];
        if (start < 0 || patch.empty())
        {
            continue;
        }
        if (const auto* ranks = isA<processorPolyPatch>(patch))
        {
            const std::streamsize nBytes = patch.size()*sizeof(Type);
            UIPstream::read
            (
                UPstream::commsTypes::nonBlocking,
                ranks->neighbProcNo(),
                reinterpret_cast<char*>(&other[start]),
                nBytes,
                ranks->tag(),
                ranks->comm()
            );
            UOPstream::write
            (
                UPstream::commsTypes::nonBlocking,
                ranks->neighbProcNo(),
                reinterpret_cast<const char*>(&own[start]),
                nBytes,
                ranks->tag(),
                ranks->comm()
            );
        }
        else
        {
            const auto& cyclic = refCast<const cyclicPolyPatch>(patch);
            const label from = starts_[cyclic.neighbPatchID()];
            std::copy_n(&own[from], patch.size(), &other[start]);
        }
    }
    UPstream::waitRequests(nRequests);
    return other;
}


// ************************************************************************* //
