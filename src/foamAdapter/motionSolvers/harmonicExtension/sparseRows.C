// SPDX-License-Identifier: GPL-3.0-or-later
#include "sparseRows.H"

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::sparseRows Foam::sparseRows::transposed(const label nColumns) const
{
    sparseRows result;
    result.starts = List<label>(nColumns + 1, Zero);
    result.columns.setSize(columns.size());
    result.values.setSize(values.size());
    for (const label column : columns)
    {
        ++result.starts[column + 1];
    }
    for (label column = 0; column < nColumns; ++column)
    {
        result.starts[column + 1] += result.starts[column];
    }
    List<label> next(result.starts);
    for (label row = 0; row < size(); ++row)
    {
        for (label k = starts[row]; k < starts[row + 1]; ++k)
        {
            const label entry = next[columns[k]]++;
            result.columns[entry] = row;
            result.values[entry] = values[k];
        }
    }
    return result;
}


Foam::sparseRows Foam::sparseRows::times
(
    const sparseRows& other,
    const label nColumns
) const
{
    rowBuilder rows(size(), nColumns);
    for (label row = 0; row < size(); ++row)
    {
        for (label k = starts[row]; k < starts[row + 1]; ++k)
        {
            const label end = other.starts[columns[k] + 1];
            for (label l = other.starts[columns[k]]; l < end; ++l)
            {
                rows.add(other.columns[l], values[k]*other.values[l]);
            }
        }
        rows.endRow(row);
    }
    return rows.finish();
}


Foam::sparseRows Foam::rowBuilder::finish()
{
    made_.columns.transfer(columns_);
    made_.values.transfer(values_);
    return std::move(made_);
}


// ************************************************************************* //
