// SPDX-License-Identifier: GPL-3.0-or-later
#include "smoothedAggregation.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- A coupling is strong from this fraction of the largest of one of its rows on
constexpr float strongFraction = 0.25;

//- Damping of the Jacobi step that smooths the prolongation
constexpr float prolongationDamping = 2.0/3.0;

//- Which couplings of a matrix are strong
class strongCouplings
{
    const sparseRows& rows_;
    List<float> largest_;

public:

    explicit strongCouplings(const sparseRows& rows)
    :
        rows_(rows),
        largest_(rows.size(), float(0))
    {
        forAll(largest_, row)
        {
            for (label k = rows.starts[row]; k < rows.starts[row + 1]; ++k)
            {
                largest_[row] = max(largest_[row], -rows.values[k]);
            }
        }
    }

    //- Whether an entry is, which is so for its row and its column alike
    bool has(const label row, const label entry) const
    {
        return
            -rows_.values[entry]
         >= strongFraction*min(largest_[row], largest_[rows_.columns[entry]]);
    }

    //- Do something with each strong entry of a row
    template<class Action>
    void forEach(const label row, const Action& action) const
    {
        for (label k = rows_.starts[row]; k < rows_.starts[row + 1]; ++k)
        {
            if (has(row, k))
            {
                action(rows_.columns[k], -rows_.values[k]);
            }
        }
    }
};

//- For each row its aggregate
class aggregation
{
    const strongCouplings& strong_;
    labelList ofRows_;
    label n_ = 0;

    //- A new aggregate of a row and its strong neighbours that have none
    void add(const label row)
    {
        ofRows_[row] = n_;
        strong_.forEach(row, [&](const label other, float)
        {
            if (ofRows_[other] < 0)
            {
                ofRows_[other] = n_;
            }
        });
        ++n_;
    }

    //- Aggregates of rows whose neighbourhood is free
    void seed()
    {
        forAll(ofRows_, row)
        {
            bool isFree = ofRows_[row] < 0;
            bool hasNeighbour = false;
            strong_.forEach(row, [&](const label other, float)
            {
                hasNeighbour = true;
                isFree = isFree && ofRows_[other] < 0;
            });
            if (isFree && hasNeighbour)
            {
                add(row);
            }
        }
    }

    //- Remaining rows join the aggregate of their strongest neighbour
    void join()
    {
        const labelList seeded(ofRows_);
        forAll(ofRows_, row)
        {
            float strongest = -1;
            if (seeded[row] < 0)
            {
                strong_.forEach(row, [&](const label other, const float value)
                {
                    if (seeded[other] >= 0 && value > strongest)
                    {
                        strongest = value;
                        ofRows_[row] = seeded[other];
                    }
                });
            }
        }
    }

public:

    aggregation(const strongCouplings& strong, const label nRows)
    :
        strong_(strong),
        ofRows_(nRows, -1)
    {
        seed();
        join();
        forAll(ofRows_, row)
        {
            if (ofRows_[row] < 0)
            {
                add(row);
            }
        }
    }

    //- Number of aggregates
    label size() const
    {
        return n_;
    }

    label of(const label row) const
    {
        return ofRows_[row];
    }
};

//- Interpolation from aggregates: constant in each, then smoothed by a damped
//  Jacobi step with the strong couplings, which keeps constants
static sparseRows smoothedProlongation
(
    const strongCouplings& strong,
    const aggregation& aggregates,
    const label nRows
)
{
    rowBuilder rows(nRows, aggregates.size());
    for (label row = 0; row < nRows; ++row)
    {
        float sum = 0;
        strong.forEach(row, [&](label, const float value)
        {
            sum += value;
        });
        const float damping = sum > 0 ? prolongationDamping : 0;
        rows.add(aggregates.of(row), 1 - damping);
        if (sum > 0)
        {
            strong.forEach(row, [&](const label other, const float value)
            {
                rows.add(aggregates.of(other), damping*value/sum);
            });
        }
        rows.endRow(row);
    }
    return rows.finish();
}

static sparseRows withDiagonal(const extensionMatrix& A)
{
    const sparseRows& off = A.offDiagonal;
    rowBuilder rows(off.size(), off.size());
    for (label row = 0; row < off.size(); ++row)
    {
        rows.add(row, A.diagonal[row]);
        for (label k = off.starts[row]; k < off.starts[row + 1]; ++k)
        {
            rows.add(off.columns[k], off.values[k]);
        }
        rows.endRow(row);
    }
    return rows.finish();
}

//- Set diagonal and other entries
static void setEntries(extensionMatrix& A, const sparseRows& entries)
{
    const label nRows = entries.size();
    A.diagonal = scalarField(nRows, Zero);
    A.uppers.setSize(nRows);
    rowBuilder rows(nRows, nRows);
    const auto addIf = [&](const label row, const auto& isWanted)
    {
        for (label k = entries.starts[row]; k < entries.starts[row + 1]; ++k)
        {
            if (isWanted(entries.columns[k]))
            {
                rows.add(entries.columns[k], entries.values[k]);
            }
            else if (entries.columns[k] == row)
            {
                A.diagonal[row] = entries.values[k];
            }
        }
    };
    for (label row = 0; row < nRows; ++row)
    {
        addIf(row, [row](const label column) { return column < row; });
        A.uppers[row] = rows.size();
        addIf(row, [row](const label column) { return column > row; });
        rows.endRow(row);
    }
    A.offDiagonal = rows.finish();
}

} // End namespace Foam


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::smoothedAggregation::smoothedAggregation(const extensionMatrix& fine)
{
    const label nRows = fine.diagonal.size();
    const strongCouplings strong(fine.offDiagonal);
    const aggregation aggregates(strong, nRows);
    const label n = aggregates.size();
    prolongation = smoothedProlongation(strong, aggregates, nRows);
    restriction = prolongation.transposed(n);
    setEntries
    (
        matrix,
        restriction.times(withDiagonal(fine), nRows).times(prolongation, n)
    );
    matrix.atFaces = fine.atFaces.times(prolongation, n);
    matrix.fromFaces = matrix.atFaces.transposed(n);
}


// ************************************************************************* //
