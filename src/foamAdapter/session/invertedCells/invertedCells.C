// SPDX-License-Identifier: GPL-3.0-or-later
#include "invertedCells.H"
#include "openfoamVersion.H"
#include "StringStream.H"
#include "Time.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- Cells of a rank that the description names
constexpr label maxNamed = 5;

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::labelList Foam::invertedCells::find() const
{
    const scalarField& volumes = mesh_.cellVolumes();
    // A collapsed cell has the volume of rounding, of either sign
    const scalar rounding = volumes.empty() ? 0 : SMALL*max(volumes);
    DynamicList<label> found;
    forAll(volumes, celli)
    {
        // Not a number is not positive either
        if (!(volumes[celli] > rounding))
        {
            found.append(celli);
        }
    }
    return labelList(found);
}


Foam::string Foam::invertedCells::describe(const labelList& cells) const
{
    OStringStream text;
    for (label i = 0; i < min(cells.size(), maxNamed); ++i)
    {
        const label celli = cells[i];
        text<< (i == 0 ? ": " : "; ") << "cell " << celli;
        if (Pstream::parRun())
        {
            text<< " of processor " << Pstream::myProcNo();
        }
        text<< " at "
            << average(pointField(mesh_.points(), mesh_.cellPoints()[celli]))
            << " with " << mesh_.cellVolumes()[celli] << " m^3";
    }
    if (cells.size() > maxNamed)
    {
        text<< "; and " << cells.size() - maxNamed << " more";
    }
    return text.str();
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::invertedCells::invertedCells
(
    const word& name,
    const fvMesh& mesh,
    std::function<void(const string&)> report
)
:
    UpdateableMeshObject<fvMesh>(name, mesh),
    mesh_(mesh),
    report_(std::move(report))
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::invertedCells::movePoints()
{
    const labelList cells(find());
    const label nCells = returnReduce(cells.size(), sumOp<label>());
    if (nCells == 0)
    {
        report_(string());
        return true;
    }
    List<string> named(Pstream::nProcs());
    named[Pstream::myProcNo()] = describe(cells);
    shareAmongRanks(named);

    OStringStream text;
    text<< "the mesh motion leaves " << nCells
        << " cells without a positive volume at time "
        << mesh_.time().timeName() << " s";
    for (const string& ofRank : named)
    {
        text<< ofRank.c_str();
    }
    report_(text.str());
    return true;
}


// ************************************************************************* //
