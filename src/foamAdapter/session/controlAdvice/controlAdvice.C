// SPDX-License-Identifier: GPL-3.0-or-later
#include "controlAdvice.H"
#include "StringStream.H"
#include "pointFields.H"
#include "slipPointPatchFields.H"
#include "surfaceFields.H"
#include "symmetryPointPatchFields.H"
#include "turbulentFluidThermoModel.H"
#include "turbulentTransportModel.H"
#include "volFields.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- Sweeps of cellDisplacement that a mesh update needs: with one the coupling
//  takes 6.3 outer correctors where it takes 3.6 with many
constexpr label leastSweeps = 20;

//- Diffusion number above which the outer correctors of the perpendicular flap
//  stop converging without SIMPLEC: they do at 4.3, not at 6
constexpr scalar largestDiffusion = 5;

//- A factor of under-relaxation other than 1, as text; empty if there is none
string factorText(const word& name, const bool given, const scalar factor)
{
    if (!given || factor == 1)
    {
        return string();
    }
    OStringStream os;
    os  << ' ' << name << ' ' << factor;
    return os.str();
}


string fieldFactor(const fvMesh& mesh, const word& name)
{
    const bool given = mesh.relaxField(name);
    return factorText
    (
        name,
        given,
        given ? mesh.fieldRelaxationFactor(name) : 1
    );
}


string equationFactor(const fvMesh& mesh, const word& name)
{
    const bool given = mesh.relaxEquation(name);
    return factorText
    (
        name,
        given,
        given ? mesh.equationRelaxationFactor(name) : 1
    );
}


//- Under-relaxation that the case has for a steady solver
void adviseRelaxation(const fvMesh& mesh, const word& UName)
{
    string text;
    for (const word& name : {word("p"), word("p_rgh")})
    {
        if (mesh.foundObject<volScalarField>(name))
        {
            text += fieldFactor(mesh, name) + fieldFactor(mesh, name + "Final");
        }
    }
    text += equationFactor(mesh, UName) + equationFactor(mesh, UName + "Final");
    if (text.empty())
    {
        return;
    }
    IOWarningInFunction(mesh.solutionDict())
        << "relaxationFactors:" << text.c_str() << "; under-relaxed, the force "
        << "lags behind the structure's motion, and a time step takes more "
        << "outer correctors; a factor without another one for 'Final' acts "
        << "in the accepted outer corrector too" << nl
        << "    remove relaxationFactors, or set them to 1: the coupling has "
        << "its own acceleration" << endl;
}


//- residualControl of the pressure
void advisePressure(const fvMesh& mesh, const pimpleControl& pimple)
{
    const dictionary controls(pimple.dict());
    const dictionary residualControl
    (
        controls.subOrEmptyDict("residualControl")
    );
    for (const word& name : {word("p"), word("p_rgh")})
    {
        const dictionary* const control =
            residualControl.findDict(name, keyType::REGEX);
        if (control && mesh.foundObject<volScalarField>(name))
        {
            IOWarningInFunction(controls)
                << "residualControl limits " << name << " to "
                << control->get<scalar>("tolerance") << ": PIMPLE compares it "
                << "with the initial residual of the last of the "
                << pimple.nCorrPISO()*(1 + pimple.nNonOrthCorr())
                << " pressure solutions in an outer corrector, which does not "
                << "fall with the outer correctors" << nl
                << "    remove it; '" << "U { tolerance 1e-4; relTol 0; }"
                << "' says when the flow has converged" << endl;
        }
    }
}


//- Solver of a mesh motion by diffusion
void adviseMotion(const fvMesh& mesh)
{
    const dictionary* const solvers = mesh.solutionDict().findDict("solvers");
    if
    (
        !solvers
     || !mesh.foundObject<volVectorField>("cellDisplacement")
    )
    {
        return;
    }
    const dictionary* const solver =
        solvers->findDict("cellDisplacement", keyType::REGEX);
    if (!solver)
    {
        return;
    }
    const label sweeps = solver->lookupOrDefault<label>("minIter", 0);
    const word type(solver->lookupOrDefault<word>("solver", word::null));
    if (type == "smoothSolver" || sweeps < leastSweeps)
    {
        IOWarningInFunction(*solver)
            << "cellDisplacement is solved by " << type << " with minIter "
            << sweeps << ": its residual is small after one sweep, while the "
            << "mesh inside has not followed the structure yet; then the "
            << "mesh moves on in every outer corrector, and the flow does not "
            << "converge" << nl
            << "    write 'solver PCG; preconditioner DIC; tolerance 1e-8; "
            << "relTol 0; minIter " << leastSweeps
            << ";', or move the mesh by harmonicBasis" << endl;
    }
}


//- Patches along which the points of other motion solvers than harmonicBasis
//  slide by the normals of the moved mesh, where those of a plane would do
void adviseSliding(const fvMesh& mesh)
{
    if (!mesh.foundObject<volVectorField>("cellDisplacement"))
    {
        return;
    }
    const pointVectorField& displacement =
        mesh.lookupObject<pointVectorField>("pointDisplacement");
    for (const pointPatchVectorField& condition : displacement.boundaryField())
    {
        // Not fixedNormalSlip, which is derived from it
        const bool isSlip = isType<slipPointPatchVectorField>(condition);
        if (isSlip || isA<symmetryPointPatchVectorField>(condition))
        {
            WarningInFunction
                << "on patch '" << condition.patch().name() << "' "
                << displacement.name() << " is of type " << condition.type()
                << ", which takes the normals of the moved mesh: where points "
                << "slide by more than a cell, rounding grows until cells turn "
                << "over" << nl
                << "    if the patch is a plane, write "
                << (isSlip ? "fixedNormalSlip" : "symmetryPlane")
                << ", or move the mesh by harmonicBasis" << endl;
        }
    }
}


//- Viscosity of the flow in the cells [m2/s]; empty if it has none
tmp<scalarField> kinematicViscosity(const fvMesh& mesh)
{
    typedef compressible::turbulenceModel compressibleModel;
    typedef incompressible::turbulenceModel incompressibleModel;

    const word& name = turbulenceModel::propertiesName;
    if (mesh.foundObject<compressibleModel>(name))
    {
        const compressibleModel& model =
            mesh.lookupObject<compressibleModel>(name);
        return model.muEff()().primitiveField()/model.rho().primitiveField();
    }
    if (mesh.foundObject<incompressibleModel>(name))
    {
        return
            1*mesh.lookupObject<incompressibleModel>(name).nuEff()()
           .primitiveField();
    }
    return tmp<scalarField>(new scalarField(mesh.nCells(), Zero));
}


//- Largest 2 nu deltaT/h^2 of the cells, h being a cell's longest extent
scalar diffusionNumber(const fvMesh& mesh)
{
    scalarField inverse(mesh.nCells(), GREAT);
    const scalarField& deltaCoeffs = mesh.deltaCoeffs().primitiveField();
    forAll(deltaCoeffs, facei)
    {
        for (const label celli : {mesh.owner()[facei], mesh.neighbour()[facei]})
        {
            inverse[celli] = min(inverse[celli], deltaCoeffs[facei]);
        }
    }
    forAll(inverse, celli)
    {
        inverse[celli] = inverse[celli] < GREAT ? inverse[celli] : 0;
    }
    return
        2*mesh.time().deltaTValue()
       *gMax((kinematicViscosity(mesh)*sqr(inverse))());
}


//- SIMPLEC where viscosity makes pressure and velocity part
void adviseConsistent(const fvMesh& mesh, const pimpleControl& pimple)
{
    if (pimple.consistent())
    {
        return;
    }
    const scalar number = diffusionNumber(mesh);
    if (number > largestDiffusion)
    {
        const dictionary controls(pimple.dict());
        IOWarningInFunction(controls)
            << "'consistent' is off, and the largest diffusion number, "
            << "2 nu deltaT/h^2 with a cell's longest extent h, is " << number
            << ": above about " << largestDiffusion << " pressure and "
            << "velocity of a viscous flow may diverge within the first time "
            << "step" << nl
            << "    add 'consistent yes;', or reduce deltaT by "
            << number/largestDiffusion << endl;
    }
}


//- A flux that is corrected in each outer corrector, which only one that ends
//  the time step would need. Two-phase solvers transport a phase with it before
//  the pressure corrects it
void adviseFlux(const fvMesh& mesh, const pimpleControl& pimple)
{
    const dictionary controls(pimple.dict());
    if
    (
        mesh.foundObject<volScalarField>("p_rgh")
     || !controls.lookupOrDefault("correctPhi", true)
    )
    {
        return;
    }
    IOWarningInFunction(controls)
        << "'correctPhi' is on, as it is if not given: a pressure equation "
        << "more in each outer corrector, up to half of the fluid's time, "
        << "for a flux that the outer corrector computes anyway; in the final "
        << "one, where the mesh stays, it changes nothing" << nl
        << "    write 'correctPhi no;'" << endl;
}

} // End anonymous namespace

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::controlAdvice::report
(
    const fvMesh& mesh,
    const pimpleControl& pimple,
    const word& UName
)
{
    adviseRelaxation(mesh, UName);
    advisePressure(mesh, pimple);
    adviseMotion(mesh);
    adviseSliding(mesh);
    adviseConsistent(mesh, pimple);
    adviseFlux(mesh, pimple);
}


void Foam::controlAdvice::reportNoForce
(
    const pimpleControl& pimple,
    const word& UName
)
{
    const dictionary controls(pimple.dict());
    IOWarningInFunction(controls)
        << "residualControl has no entry for " << UName << ", and the "
        << "structure's case file has 'force: none': a time step ends when "
        << "the structure has settled, however wrong its force is; a heavy "
        << "structure, which hardly moves in a time step, has been measured "
        << "to have ten times the error at a tolerance of 5e-3" << nl
        << "    remove 'force: none' from 'coupling.convergence' of the case "
        << "file, or add '" << UName << " { tolerance 1e-4; relTol 0; }' to "
        << "residualControl" << endl;
}


// ************************************************************************* //
