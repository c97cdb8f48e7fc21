// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupledFaces.H"
#include "cyclicPolyPatch.H"
#include "processorPolyPatch.H"
#include "PstreamReduceOps.H"

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


// ************************************************************************* //
