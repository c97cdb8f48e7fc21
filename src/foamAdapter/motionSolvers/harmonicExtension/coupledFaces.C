// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupledFaces.H"
#include "cyclicPolyPatch.H"
#include "processorPolyPatch.H"
#include "PstreamReduceOps.H"
#include "UIPstream.H"
#include "UOPstream.H"

#include <algorithm>

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::coupledFaces::coupledFaces(const polyMesh& mesh)
:
    patches_(mesh.boundaryMesh()),
    starts_(patches_.size(), -1)
{
    DynamicList<label> cells;
    for (const polyPatch& patch : patches_)
    {
        if (isA<cyclicPolyPatch>(patch) || isA<processorPolyPatch>(patch))
        {
            starts_[patch.index()] = cells.size();
            cells.append(patch.faceCells());
        }
    }
    cells_.transfer(cells);
    any_ = returnReduce(!cells_.empty(), orOp<bool>());
}


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
