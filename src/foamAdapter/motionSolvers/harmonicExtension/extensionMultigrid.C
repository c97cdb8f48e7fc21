// SPDX-License-Identifier: GPL-3.0-or-later
#include "extensionMultigrid.H"
#include "globalIndex.H"
#include "PstreamReduceOps.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- Number of unknowns on all ranks that are solved for directly
constexpr label coarsestSize = 400;

//- Largest number that is inverted where aggregation ends before: each rank
//  has this matrix
constexpr label mostInverted = 2000;

//- A coarser level that keeps more of the unknowns is no gain
constexpr scalar leastCoarsening = 0.9;

//- Relative increase of the coarsest level's diagonal: a part of the mesh that
//  touches nothing given is singular
constexpr scalar regularisation = 1e-6;

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::extensionMultigrid::coarsen()
{
    label n = returnReduce(finest_.diagonal.size(), sumOp<label>());
    bool isCoarser = true;
    while (n > coarsestSize && isCoarser)
    {
        autoPtr<smoothedAggregation> next
        (
            new smoothedAggregation(matrix(coarsenings_.size()))
        );
        const label nNext =
            returnReduce(next->matrix.diagonal.size(), sumOp<label>());
        isCoarser = nNext <= leastCoarsening*n;
        if (isCoarser)
        {
            coarsenings_.append(next.ptr());
            n = nNext;
        }
    }

    fields_.setSize(coarsenings_.size() + 1);
    forAll(fields_, level)
    {
        const label nRows = matrix(level).diagonal.size();
        fields_[level].source.setSize(level == 0 ? 0 : nRows);
        fields_[level].solution.setSize(nRows);
        fields_[level].residual.setSize(nRows);
    }
}


void Foam::extensionMultigrid::invertCoarsest()
{
    const extensionMatrix& A = matrix(coarsenings_.size());
    const label nRows = A.diagonal.size();
    const globalIndex all(nRows);
    const label n = returnReduce(nRows, sumOp<label>());
    nCoarsest_ = n;
    coarsestStart_ = all.localStart();
    if (n > mostInverted)
    {
        return;
    }

    // The entries are the products with unit vectors
    scalarField entries(n*n, Zero);
    List<floatBlock> x(nRows), y(nRows);
    for (label first = 0; first < n; first += blockSize)
    {
        x = floatBlock{};
        for (label i = 0; i < min(blockSize, n - first); ++i)
        {
            if (all.isLocal(first + i))
            {
                x[all.toLocal(first + i)][i] = 1;
            }
        }
        y = floatBlock{};
        subtractCoupled(A, x, y);
        for (label row = 0; row < nRows; ++row)
        {
            A.offDiagonal.addProduct(row, -1.0f, x, y[row]);
            for (label i = 0; i < min(blockSize, n - first); ++i)
            {
                entries[(coarsestStart_ + row)*n + first + i] =
                    A.diagonal[row]*x[row][i] - y[row][i];
            }
        }
    }
    reduce(entries, sumOp<scalarField>());

    scalarSquareMatrix dense(n);
    for (label row = 0; row < n; ++row)
    {
        for (label column = 0; column < n; ++column)
        {
            dense(row, column) = entries[row*n + column];
        }
        dense(row, row) *= 1 + regularisation;
    }
    labelList pivots(n);
    LUDecompose(dense, pivots);
    inverse_ = List<scalarField>(nRows, scalarField(n, Zero));
    forAll(inverse_, row)
    {
        // A column, and a row because the matrix is symmetric
        inverse_[row][coarsestStart_ + row] = 1;
        LUBacksubstitute(dense, pivots, inverse_[row]);
    }
}


void Foam::extensionMultigrid::subtractCoupled
(
    const extensionMatrix& A,
    const List<floatBlock>& x,
    List<floatBlock>& y
) const
{
    if (!faces_.any())
    {
        return;
    }
    List<floatBlock> own(faces_.size(), floatBlock{});
    forAll(own, face)
    {
        A.atFaces.addProduct(face, faceValues_[face], x, own[face]);
    }
    const List<floatBlock> beyond(faces_.beyond(own));
    forAll(y, row)
    {
        A.fromFaces.addProduct(row, -1.0f, beyond, y[row]);
    }
}


void Foam::extensionMultigrid::sweepFromZero
(
    const label level,
    const List<floatBlock>& source
)
{
    const extensionMatrix& A = matrix(level);
    List<floatBlock>& x = fields_[level].solution;
    forAll(x, row)
    {
        floatBlock sum(source[row]);
        A.offDiagonal.addProduct
        (
            A.offDiagonal.starts[row],
            A.uppers[row],
            -1.0f,
            x,
            sum
        );
        x[row].set(1/A.diagonal[row], sum);
    }
}


void Foam::extensionMultigrid::sweepBack
(
    const label level,
    const List<floatBlock>& source
)
{
    const extensionMatrix& A = matrix(level);
    List<floatBlock>& x = fields_[level].solution;
    forAllReverse(x, row)
    {
        floatBlock sum(source[row]);
        A.offDiagonal.addProduct(row, -1.0f, x, sum);
        x[row].set(1/A.diagonal[row], sum);
    }
}


void Foam::extensionMultigrid::restrictResidual(const label level)
{
    const extensionMatrix& A = matrix(level);
    levelFields& fine = fields_[level];
    forAll(fine.residual, row)
    {
        floatBlock sum{};
        A.offDiagonal.addProduct
        (
            A.uppers[row],
            A.offDiagonal.starts[row + 1],
            -1.0f,
            fine.solution,
            sum
        );
        fine.residual[row] = sum;
    }
    subtractCoupled(A, fine.solution, fine.residual);

    const sparseRows& restriction = coarsenings_[level].restriction;
    List<floatBlock>& coarse = fields_[level + 1].source;
    coarse = floatBlock{};
    forAll(coarse, row)
    {
        restriction.addProduct(row, 1.0f, fine.residual, coarse[row]);
    }
}


void Foam::extensionMultigrid::solveCoarsest(const List<floatBlock>& source)
{
    List<floatBlock>& x = fields_[coarsenings_.size()].solution;
    scalarField sources(nCoarsest_*blockSize, Zero);
    forAll(source, row)
    {
        for (label i = 0; i < blockSize; ++i)
        {
            sources[(coarsestStart_ + row)*blockSize + i] = source[row][i];
        }
    }
    reduce(sources, sumOp<scalarField>());
    forAll(x, row)
    {
        scalarBlock sum{};
        forAll(inverse_[row], other)
        {
            for (label i = 0; i < blockSize; ++i)
            {
                sum[i] += inverse_[row][other]*sources[other*blockSize + i];
            }
        }
        x[row].set(1, sum);
    }
}


void Foam::extensionMultigrid::correct(const label level)
{
    restrictResidual(level);
    cycle(level + 1, fields_[level + 1].source);
    const sparseRows& prolongation = coarsenings_[level].prolongation;
    const List<floatBlock>& correction = fields_[level + 1].solution;
    List<floatBlock>& x = fields_[level].solution;
    forAll(x, row)
    {
        prolongation.addProduct(row, 1.0f, correction, x[row]);
    }
}


void Foam::extensionMultigrid::cycle
(
    const label level,
    const List<floatBlock>& source
)
{
    const bool isCoarsest = level == coarsenings_.size();
    if (isCoarsest && nCoarsest_ <= mostInverted)
    {
        solveCoarsest(source);
        return;
    }
    sweepFromZero(level, source);
    if (!isCoarsest)
    {
        correct(level);
    }

    levelFields& fields = fields_[level];
    if (faces_.any())
    {
        fields.residual = source;
        subtractCoupled(matrix(level), fields.solution, fields.residual);
    }
    sweepBack(level, faces_.any() ? fields.residual : source);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::extensionMultigrid::extensionMultigrid
(
    const extensionMatrix& matrix,
    const coupledFaces& faces,
    const List<float>& faceValues
)
:
    finest_(matrix),
    faces_(faces),
    faceValues_(faceValues)
{
    coarsen();
    invertCoarsest();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

const Foam::List<Foam::floatBlock>& Foam::extensionMultigrid::precondition
(
    const List<floatBlock>& source
)
{
    cycle(0, source);
    return fields_[0].solution;
}


// ************************************************************************* //
