// SPDX-License-Identifier: GPL-3.0-or-later
#include "enclosedFluid.H"
#include "basicThermo.H"
#include "dictionaryChecks.H"
#include "inletOutletFvPatchFields.H"
#include "StringStream.H"
#include "Time.H"
#include "transformFvPatchFields.H"
#include "volFields.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

const Foam::Enum<Foam::enclosedFluid::choice>
Foam::enclosedFluid::choiceNames
({
    {choice::refuse, "refuse"},
    {choice::accept, "accept"}
});

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool Foam::enclosedFluid::isOpen
(
    const word& UName,
    const label patchi
) const
{
    const fvPatchVectorField& U =
        mesh_.lookupObject<volVectorField>(UName).boundaryField()[patchi];
    const word& type = U.patch().type();
    return
        !U.coupled()
     && !polyPatch::constraintType(type)
     && !isA<transformFvPatchVectorField>(U)
     && (!U.fixesValue() || isA<inletOutletFvPatchVectorField>(U));
}


bool Foam::enclosedFluid::find(const word& pName, const word& UName) const
{
    if (mesh_.foundObject<basicThermo>(basicThermo::dictName))
    {
        return false;
    }
    for (const word& name : {word("p_rgh"), word("p_gh"), pName})
    {
        if (mesh_.foundObject<volScalarField>(name))
        {
            if (!mesh_.lookupObject<volScalarField>(name).needReference())
            {
                return false;
            }
            break;
        }
    }
    bool open = false;
    forAll(mesh_.boundary(), patchi)
    {
        open =
            open
         || (mesh_.boundary()[patchi].size() && isOpen(UName, patchi));
    }
    return !returnReduce(open, orOp<bool>());
}


Foam::string Foam::enclosedFluid::describePatches(const word& UName) const
{
    const volVectorField& U = mesh_.lookupObject<volVectorField>(UName);
    OStringStream os;
    for
    (
        label patchi = 0;
        patchi < mesh_.boundaryMesh().nNonProcessor();
        ++patchi
    )
    {
        const fvPatch& patch = mesh_.boundary()[patchi];
        if
        (
            !polyPatch::constraintType(patch.type())
         && returnReduce(patch.patch().size(), sumOp<label>()) > 0
        )
        {
            os  << (os.str().empty() ? "" : ", ") << patch.name() << " ("
                << U.boundaryField()[patchi].type() << ')';
        }
    }
    return os.str();
}


Foam::scalar Foam::enclosedFluid::inflow(const word& UName) const
{
    const volVectorField& U = mesh_.lookupObject<volVectorField>(UName);
    scalar sum = 0;
    forAll(mesh_.boundary(), patchi)
    {
        const fvPatchVectorField& Up = U.boundaryField()[patchi];
        if (!Up.coupled() && Up.fixesValue())
        {
            sum -= Foam::sum(Up & mesh_.boundary()[patchi].Sf());
        }
    }
    return returnReduce(sum, sumOp<scalar>());
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::enclosedFluid::enclosedFluid
(
    const fvMesh& mesh,
    const dictionary& dict,
    const word& pName,
    const word& UName
)
:
    mesh_(mesh),
    isEnclosed_(find(pName, UName)),
    volume_(gSum(mesh.V().field()))
{
    const choice chosen =
        readChoice("enclosedFluid", dict, choiceNames, choice::refuse);
    if (!isEnclosed_)
    {
        return;
    }
    if (chosen == choice::accept)
    {
        Info<< "    the fluid is enclosed, as accepted by 'enclosedFluid "
            << "accept': volume " << volume_ << " m3" << endl;
        return;
    }
    FatalIOErrorInFunction(dict)
        << "the fluid is enclosed: it is incompressible, and no patch fixes "
        << "the pressure or lets the fluid out: "
        << describePatches(UName).c_str() << nl
        << "    a structure that moves changes the fluid's volume of "
        << volume_ << " m3, into which " << inflow(UName) << " m3/s flow at "
        << "the start, and the level of the pressure is arbitrary" << nl
        << "    open a patch (a fixed value for p, inletOutlet or zeroGradient "
        << "for " << UName << "), use a compressible solver, or accept it by "
        << "'enclosedFluid accept;' if the structure keeps the volume"
        << exit(FatalIOError);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::enclosedFluid::report() const
{
    if (isEnclosed_ && mesh_.time().writeTime())
    {
        const scalar change = gSum(mesh_.V().field()) - volume_;
        Info<< "structureCoupling: the volume of the enclosed fluid has "
            << "changed by " << change << " m3 since the start, "
            << change/volume_ << " of it" << endl;
    }
}


// ************************************************************************* //
