// SPDX-License-Identifier: GPL-3.0-or-later
#include "conservationAudit.H"
#include "surfaceFields.H"
#include "Time.H"
#include "volFields.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

const Foam::FixedList<Foam::word, 4> quantities
({
    "force", "moment", "power", "sweptVolume"
});

//- Reason for a difference between the two sides
const char* reason(const Foam::word& quantity)
{
    if (quantity == "force")
    {
        return "the transfer loses or adds forces";
    }
    if (quantity == "moment")
    {
        return
            "the two surfaces do not lie on each other: see the gaps in the "
            "mapping report";
    }
    if (quantity == "power")
    {
        return
            "fluid and structure do not move alike: the step ends with too "
            "large a coupling residual, the mesh does not follow the "
            "structure, or its faces are too coarse for the deflection "
            "('coupling.mapping.loads' of the case file)";
    }
    return
        "fluid and structure do not move alike: the step ends with too large a "
        "coupling residual, or the mesh does not follow the structure";
}

} // End anonymous namespace

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::conservationAudit::readLimit(const dictionary& dict)
{
    if (!dict.found("conservationLimit"))
    {
        return 0.01;
    }
    const token limit(dict.lookup("conservationLimit"));
    if (limit.isWord() && limit.wordToken() == "off")
    {
        return 0;
    }
    if (!limit.isNumber() || limit.number() <= 0)
    {
        FatalIOErrorInFunction(dict)
            << "'conservationLimit' is " << limit
            << ": it must be a positive number or 'off'"
            << exit(FatalIOError);
    }
    return limit.number();
}


void Foam::conservationAudit::addPatch
(
    const label patchi,
    const vectorField& forces,
    const label start,
    differences& magnitudes
)
{
    const polyPatch& patch = mesh_.boundaryMesh()[patchi];
    const pointField& points = patch.localPoints();
    const vectorField motions
    (
        points - pointField(mesh_.oldPoints(), patch.meshPoints())
    );
    const vectorField& centres = mesh_.Cf().boundaryField()[patchi];
    const scalarField swept
    (
        mesh_.phi().boundaryField()[patchi]*mesh_.time().deltaTValue()
    );

    forAll(patch, facei)
    {
        const vector& force = forces[start + facei];
        const vector motion
        (
            patch.localFaces()[facei].average(points, motions)
           /mesh_.time().deltaTValue()
        );

        fluid_.force += force;
        fluid_.moment += centres[facei] ^ force;
        fluid_.power += force & motion;
        fluid_.sweptVolume += swept[facei];

        magnitudes[0] += mag(force);
        magnitudes[2] += mag(force)*mag(motion);
        magnitudes[3] += mag(swept[facei]);
    }
}


void Foam::conservationAudit::warn
(
    const word& quantity,
    const scalar difference
)
{
    if (difference > limit_ && warned_.insert(quantity))
    {
        WarningInFunction
            << "time " << mesh_.time().timeName() << " s: the " << quantity
            << " of the interface differs between fluid and structure by "
            << difference << " (conservationLimit " << limit_ << "): "
            << reason(quantity) << nl
            << "    reported once; conservation.dat has every step" << endl;
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::conservationAudit::conservationAudit
(
    const fvMesh& mesh,
    const dictionary& dict
)
:
    mesh_(mesh),
    limit_(readLimit(dict)),
    scale_(scalar(0))
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::conservationAudit::measure
(
    const couplingInterface& interface,
    const vectorField& forces
)
{
    fluid_ = balance();
    differences magnitudes(scalar(0));
    boundBox bounds;
    label start = 0;
    for (const label patchi : interface.patches())
    {
        addPatch(patchi, forces, start, magnitudes);
        start += mesh_.boundaryMesh()[patchi].size();
        bounds.add(mesh_.boundaryMesh()[patchi].localPoints());
    }
    bounds.reduce();

    reduce(fluid_.force, sumOp<vector>());
    reduce(fluid_.moment, sumOp<vector>());
    reduce(fluid_.power, sumOp<scalar>());
    reduce(fluid_.sweptVolume, sumOp<scalar>());
    for (scalar& magnitude : magnitudes)
    {
        reduce(magnitude, sumOp<scalar>());
    }
    interface.removeEmptyDirection(fluid_.force, fluid_.moment);

    scale_[0] = magnitudes[0];
    scale_[1] = magnitudes[0]*0.5*bounds.mag();
    scale_[2] = max(scale_[2], magnitudes[2]);
    scale_[3] = max(scale_[3], magnitudes[3]);
}


void Foam::conservationAudit::compare(const balance& structure)
{
    structure_ = structure;
    const differences found(relative());
    forAll(found, i)
    {
        warn(quantities[i], found[i]);
    }
}


Foam::conservationAudit::differences Foam::conservationAudit::relative() const
{
    differences found;
    found[0] = mag(structure_.force - fluid_.force);
    found[1] = mag(structure_.moment - fluid_.moment);
    found[2] = mag(structure_.power - fluid_.power);
    found[3] = mag(structure_.sweptVolume - fluid_.sweptVolume);
    forAll(found, i)
    {
        found[i] /= max(scale_[i], VSMALL);
    }
    return found;
}


Foam::wordList Foam::conservationAudit::columns()
{
    DynamicList<word> names;
    for (const word side : {"fluid", "structure"})
    {
        for (const char* quantity : {"Force", "Moment"})
        {
            for (const char* component : {"_x", "_y", "_z"})
            {
                names.append(side + quantity + component);
            }
        }
        names.append(side + "Power");
        names.append(side + "SweptVolume");
    }
    for (const word& quantity : quantities)
    {
        names.append(quantity + "Difference");
    }
    return wordList(std::move(names));
}


void Foam::conservationAudit::writeRow(Ostream& os) const
{
    for (const balance* side : {&fluid_, &structure_})
    {
        for (const vector& v : {side->force, side->moment})
        {
            os  << tab << v.x() << tab << v.y() << tab << v.z();
        }
        os  << tab << side->power << tab << side->sweptVolume;
    }
    for (const scalar difference : relative())
    {
        os  << tab << difference;
    }
}


// ************************************************************************* //
