// SPDX-License-Identifier: GPL-3.0-or-later
/*---------------------------------------------------------------------------*\
Application
    swingMesh

Description
    Moves the mesh around a flag that swings with growing amplitude, by the
    case's motion solver, until the mesh fails. Prints for each amplitude the
    largest non-orthogonality within the swing, the smallest ratio of a cell's
    volume to that at rest, and the processor time of a move: of the points'
    new places, and of what the mesh does with them (volumes swept, and all
    geometry that an equation asks for). Of the times it prints the median,
    which leaves out the moves that build something, and of the points' the
    longest too, and the memory that the first move has needed at its most.

    Entries of system/swingMeshDict: shape (bentAxis, squeeze) and the entries
    of that class; patch; amplitudes [m]; stepsASwing; movesAStep, all to the
    same position, as a coupled step has them;
    reference, which is 0: the motion of the tip [m] at which the mesh is made
    the motion's reference.

\*---------------------------------------------------------------------------*/

#include "argList.H"
#include "bentAxis.H"
#include "displacementMotionSolver.H"
#include "fixedValuePointPatchFields.H"
#include "fvMesh.H"
#include "mathematicalConstants.H"
#include "motionSolver.H"
#include "pointFields.H"
#include "primitiveMeshTools.H"
#include "squeeze.H"
#include "surfaceFields.H"
#include "Time.H"
#include "unitConversion.H"
#include "volFields.H"

#include <algorithm>
#include <ctime>
#include <fstream>
#include <functional>
#include <string>
#include <vector>

using namespace Foam;

//- Processor time of this process [ms]
static scalar processorTime()
{
    timespec now;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return 1e3*now.tv_sec + 1e-6*now.tv_nsec;
}


static scalar median(std::vector<scalar> values)
{
    const auto middle = values.begin() + values.size()/2;
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}


//- Memory of this process [MB]: VmRSS now, VmHWM at most since resetPeak()
static scalar memory(const std::string& name)
{
    std::ifstream status("/proc/self/status");
    std::string word;
    while (status >> word && word != name + ':')
    {}
    scalar kilobytes = 0;
    status >> kilobytes;
    return 1e-3*kilobytes;
}


static void resetPeak()
{
    std::ofstream("/proc/self/clear_refs") << 5;
}


//- Geometry that any equation asks for
static void evaluateGeometry(const fvMesh& mesh)
{
    mesh.V();
    mesh.Sf();
    mesh.magSf();
    mesh.C();
    mesh.Cf();
    mesh.weights();
    mesh.deltaCoeffs();
    mesh.nonOrthDeltaCoeffs();
    mesh.nonOrthCorrectionVectors();
}


//- Between the line of two centres and the normal of their face [degrees]
static scalar nonOrthogonality(const fvMesh& mesh)
{
    const scalarField cosines
    (
        primitiveMeshTools::faceOrthogonality
        (
            mesh,
            mesh.faceAreas(),
            mesh.cellCentres()
        )
    );
    scalar smallest = 1;
    for (label facei = 0; facei < mesh.nInternalFaces(); ++facei)
    {
        smallest = min(smallest, cosines[facei]);
    }
    return Foam::radToDeg(Foam::acos(max(scalar(-1), smallest)));
}


//- Values that move a patch
static fixedValuePointPatchVectorField& displacementOf
(
    pointVectorField& displacement,
    const label patchi
)
{
    return refCast<fixedValuePointPatchVectorField>
    (
        displacement.boundaryFieldRef()[patchi]
    );
}


//- Displacement of points at rest by an amplitude
using motionShape =
    std::function<vectorField(const pointField&, const scalar amplitude)>;


template<class Shape>
static motionShape shapeOf(const dictionary& dict)
{
    return [shape = Shape(dict)](const pointField& points, const scalar size)
    {
        return shape.displacement(points, size);
    };
}


//- The same motion solver with the mesh as it is for its reference
static autoPtr<displacementMotionSolver> beginHere
(
    const fvMesh& mesh,
    const motionSolver& solver
)
{
    pointIOField points0(points0MotionSolver::points0IO(mesh));
    static_cast<pointField&>(points0) = mesh.points();
    pointVectorField displacement
    (
        mesh.lookupObject<pointVectorField>("pointDisplacement")
    );
    displacement == dimensionedVector(dimLength, Zero);
    IOobject io(solver);
    io.registerObject() = false;
    io.readOpt() = IOobject::MUST_READ;
    return displacementMotionSolver::New
    (
        solver.get<word>("solver"),
        mesh,
        IOdictionary(io),
        displacement,
        points0
    );
}


int main(int argc, char *argv[])
{
    argList::noParallel();
    const argList args(argc, argv);
    Time runTime(Time::controlDictName, args);
    runTime.setDeltaT(1);
    runTime.setEndTime(GREAT);
    runTime.functionObjects().off();
    fvMesh mesh
    (
        IOobject
        (
            fvMesh::defaultRegion,
            runTime.timeName(),
            runTime,
            IOobject::MUST_READ
        )
    );
    autoPtr<motionSolver> motion(motionSolver::New(mesh));

    const IOdictionary dict
    (
        IOobject("swingMeshDict", runTime.system(), mesh, IOobject::MUST_READ)
    );
    const motionShape displacementAt
    (
        dict.getOrDefault<word>("shape", "bentAxis") == "squeeze"
      ? shapeOf<squeeze>(dict)
      : shapeOf<bentAxis>(dict)
    );
    const label patchi =
        mesh.boundaryMesh().findPatchID(dict.get<word>("patch"));
    const label nSteps = dict.get<label>("stepsASwing");
    const label nMoves = dict.get<label>("movesAStep");
    const pointField places(mesh.boundaryMesh()[patchi].localPoints());
    fixedValuePointPatchVectorField* condition = &displacementOf
    (
        mesh.lookupObjectRef<pointVectorField>("pointDisplacement"),
        patchi
    );
    const scalarField volumesAtRest(mesh.V().field());

    const scalar reference = dict.getOrDefault<scalar>("reference", 0);
    const vectorField atReference(displacementAt(places, reference));
    if (reference != 0)
    {
        ++runTime;
        *condition == atReference;
        mesh.movePoints(motion->newPoints()());
        motion.reset(beginHere(mesh, *motion).ptr());
        condition = &displacementOf
        (
            refCast<displacementMotionSolver>(*motion).pointDisplacement(),
            patchi
        );
    }

    evaluateGeometry(mesh);
    resetPeak();
    const scalar memoryBefore = memory("VmRSS");
    scalar memoryToBuild = 0;

    for (const scalar amplitude : dict.get<scalarList>("amplitudes"))
    {
        std::vector<scalar> solving, moving;
        scalar angle = 0, ratio = 1;
        for (label step = 1; step <= nSteps && ratio > 0; ++step)
        {
            ++runTime;
            const scalar phase = constant::mathematical::twoPi*step/nSteps;
            *condition ==
                displacementAt(places, amplitude*Foam::sin(phase))
              - atReference;
            for (label move = 0; move < nMoves; ++move)
            {
                const scalar start = processorTime();
                const pointField points(motion->newPoints());
                const scalar solved = processorTime();
                if (memoryToBuild == 0)
                {
                    memoryToBuild = memory("VmHWM") - memoryBefore;
                }
                mesh.movePoints(points);
                evaluateGeometry(mesh);
                solving.push_back(solved - start);
                moving.push_back(processorTime() - solved);
            }
            angle = max(angle, nonOrthogonality(mesh));
            ratio = min(ratio, min(mesh.V().field()/volumesAtRest));
        }
        Info<< "amplitude " << amplitude << " nonOrthogonality " << angle
            << " volumeRatio " << ratio << " places " << median(solving)
            << " ms, mesh " << median(moving) << " ms, longest "
            << *std::max_element(solving.begin(), solving.end())
            << " ms, memory " << memoryToBuild << " MB"
            << endl;
        if (ratio <= 0)
        {
            Info<< "failed" << endl;
            break;
        }
    }
    return 0;
}


// ************************************************************************* //
