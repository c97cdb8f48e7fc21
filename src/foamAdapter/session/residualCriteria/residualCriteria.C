// SPDX-License-Identifier: GPL-3.0-or-later
#include "residualCriteria.H"
#include "openfoamVersion.H"
#include "StringStream.H"
#include "volFields.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- A component of the velocity that is smaller, relative to the largest, may be
//  what the linear solvers leave where nothing flows
constexpr Foam::scalar stillFraction = 1e-4;

//- Tolerance of such a component where residualControl has no entry for the
//  velocity
constexpr Foam::scalar usualTolerance = 1e-4;

//- Digits of residuals in messages
constexpr int digits = 4;

} // End anonymous namespace

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::label Foam::residualCriteria::find(const word& entryName) const
{
    forAll(controls_, i)
    {
        if (controls_[i].name == entryName)
        {
            return i;
        }
    }
    return -1;
}


const Foam::residualCriteria::control* Foam::residualCriteria::appliedTo
(
    const word& fieldName
) const
{
    for (const control& c : controls_)
    {
        if (c.name.match(fieldName))
        {
            return &c;
        }
    }
    return nullptr;
}


void Foam::residualCriteria::reportChange
(
    const control& before,
    const scalar tolerance
) const
{
    Info<< "structureCoupling: residualControl: the tolerance of "
        << before.name << " is now " << tolerance;
    if (before.name.match(couplingName_))
    {
        Info<< "; the coupling keeps that of its start until the next start";
    }
    Info<< endl;
}


void Foam::residualCriteria::readControls()
{
    const dictionary& present = controlsNow(mesh_, algorithm_);
    for (const entry& e : present)
    {
        if (!e.isDict())
        {
            continue;   // PIMPLE refuses it
        }
        const control read
        {
            wordRe(e.keyword(), wordRe::DETECT),
            e.dict().get<scalar>("tolerance"),
            e.dict().lookupOrDefault<scalar>("relTol", 0)
        };
        const label i = find(e.keyword());
        if (i < 0)
        {
            controls_.append(read);
            continue;
        }
        if (controls_[i].tolerance != read.tolerance)
        {
            reportChange(controls_[i], read.tolerance);
        }
        controls_[i] = read;
    }
    for (const control& c : controls_)
    {
        if (!present.found(c.name, keyType::LITERAL) && removed_.insert(c.name))
        {
            Info<< "structureCoupling: residualControl: the entry " << c.name
                << " has been removed; it stays in force until the next start"
                << endl;
        }
    }
}


void Foam::residualCriteria::readMomentum()
{
    List<SolverPerformance<vector>> performances;
    // Without a momentum predictor there are none
    solvesMomentum_ =
        performanceStore(mesh_, 0).solverPerformanceDict().readIfPresent
        (
            UName_,
            performances
        )
     && !performances.empty();
    momentum_ =
        solvesMomentum_
      ? performances.last().initialResidual()
      : vector(Zero);
}


void Foam::residualCriteria::findStill()
{
    vector largest(Zero);
    for
    (
        const vector& U
      : mesh_.lookupObject<volVectorField>(UName_).primitiveField()
    )
    {
        largest = max(largest, cmptMag(U));
    }
    reduce(largest, maxOp<vector>());
    const control* const applied = appliedTo(UName_);
    const scalar tolerance = applied ? applied->tolerance : usualTolerance;
    fraction_ = largest/max(cmptMax(largest), VSMALL);
    for (direction cmpt = 0; cmpt < vector::nComponents; ++cmpt)
    {
        isStill_[cmpt] =
            fraction_[cmpt] <= stillFraction
         && fraction_[cmpt]*momentum_[cmpt] < tolerance;
    }
}


void Foam::residualCriteria::enterStill()
{
    const control* const applied = appliedTo(UName_);
    bool blocks = false;
    for (direction cmpt = 0; cmpt < vector::nComponents; ++cmpt)
    {
        if
        (
            !applied
         || !isStill_[cmpt]
         || momentum_[cmpt] < applied->tolerance
        )
        {
            continue;
        }
        blocks = true;
        if (!isReported_[cmpt])
        {
            isReported_[cmpt] = true;
            OStringStream os;
            os.precision(digits);
            os  << "nothing flows along " << vector::componentNames[cmpt]
                << ": " << UName_ << vector::componentNames[cmpt]
                << " is at most " << fraction_[cmpt] << " of the largest "
                << "velocity component; its residual " << momentum_[cmpt]
                << " is noise, and is not compared with the tolerance "
                << applied->tolerance;
            Info<< "structureCoupling: " << os.str().c_str() << endl;
        }
    }
    if (!blocks)
    {
        return;
    }
    List<SolverPerformance<vector>> performances;
    performanceStore(mesh_, 0).solverPerformanceDict().readEntry
    (
        UName_,
        performances
    );
    SolverPerformance<vector> counted(performances.last());
    for (direction cmpt = 0; cmpt < vector::nComponents; ++cmpt)
    {
        if (isStill_[cmpt])
        {
            counted.initialResidual()[cmpt] = 0;
        }
    }
    performanceStore(mesh_, 0).setSolverPerformance(UName_, counted);
}


template<class Type>
bool Foam::residualCriteria::addComponents
(
    const entry& performances,
    const control& applied,
    DynamicList<compared>& found
) const
{
    typedef GeometricField<Type, fvPatchField, volMesh> fieldType;
    const word& fieldName = performances.keyword();
    if (!mesh_.foundObject<fieldType>(fieldName))
    {
        return false;
    }
    const List<SolverPerformance<Type>> all(performances.stream());
    const Type residual(all.last().initialResidual());
    // PIMPLE's relTol refers to the largest component at the first solution
    const scalar relative =
        applied.relTol*cmptMax(all.first().initialResidual());
    const typename pTraits<Type>::labelType isSolved
    (
        mesh_.validComponents<Type>()
    );
    for (direction cmpt = 0; cmpt < pTraits<Type>::nComponents; ++cmpt)
    {
        if (Foam::component(isSolved, cmpt) != -1)
        {
            const scalar value = Foam::component(residual, cmpt);
            found.append
            ({
                fieldName + pTraits<Type>::componentNames[cmpt],
                value,
                applied.tolerance,
                value < applied.tolerance || value < relative
            });
        }
    }
    return true;
}


Foam::List<Foam::residualCriteria::compared>
Foam::residualCriteria::compareAll() const
{
    DynamicList<compared> found;
    for (const entry& e : performanceStore(mesh_, 0).solverPerformanceDict())
    {
        const control* const applied = appliedTo(e.keyword());
        if (applied && e.keyword() != couplingName_)
        {
            addComponents<scalar>(e, *applied, found)
         || addComponents<vector>(e, *applied, found)
         || addComponents<sphericalTensor>(e, *applied, found)
         || addComponents<symmTensor>(e, *applied, found)
         || addComponents<tensor>(e, *applied, found);
        }
    }
    return List<compared>(std::move(found));
}


// * * * * * * * * * * * * * Static Member Functions * * * * * * * * * * * * //

const Foam::dictionary& Foam::residualCriteria::controlsNow
(
    const fvMesh& mesh,
    const word& algorithm
)
{
    const dictionary* controls =
        mesh.solutionDict().findDict(algorithm, keyType::REGEX);
    if (controls)
    {
        controls = controls->findDict("residualControl", keyType::REGEX);
    }
    return controls ? *controls : dictionary::null;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::residualCriteria::residualCriteria
(
    const word& couplingName,
    const word& UName,
    const fvMesh& mesh,
    const pimpleControl& pimple
)
:
    mesh_(mesh),
    pimple_(pimple),
    algorithm_(pimple.dict().dictName()),
    couplingName_(couplingName),
    UName_(UName),
    solvesMomentum_(false),
    momentum_(Zero),
    fraction_(Zero),
    isStill_(false),
    isReported_(false)
{
    readControls();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::residualCriteria::update()
{
    readControls();
    readMomentum();
    findStill();
    enterStill();
}


Foam::scalar Foam::residualCriteria::momentum() const
{
    scalar largest = 0;
    for (direction cmpt = 0; cmpt < vector::nComponents; ++cmpt)
    {
        if (!isStill_[cmpt])
        {
            largest = max(largest, momentum_[cmpt]);
        }
    }
    return largest;
}


bool Foam::residualCriteria::momentumConverged() const
{
    const control* const applied = appliedTo(UName_);
    return !applied || momentum() < applied->tolerance;
}


bool Foam::residualCriteria::fluidConverged() const
{
    for (const compared& c : compareAll())
    {
        if (!c.isMet)
        {
            return false;
        }
    }
    return true;
}


Foam::string Foam::residualCriteria::describe
(
    const scalar residual,
    const scalar tolerance,
    const bool converged
) const
{
    DynamicList<compared> all;
    all.append({couplingName_, residual, tolerance, converged});
    all.append(compareAll());

    OStringStream missed;
    OStringStream met;
    missed.precision(digits);
    met.precision(digits);
    for (const compared& c : all)
    {
        OStringStream& os = c.isMet ? met : missed;
        os  << (os.str().empty() ? "" : ", ") << c.name << ' ' << c.residual
            << " (tolerance " << c.tolerance << ')';
    }
    string text("above the tolerance of residualControl: " + missed.str());
    if (!met.str().empty())
    {
        text += "; below it: " + met.str();
    }
    return text + describeStill();
}


Foam::string Foam::residualCriteria::describeStill() const
{
    OStringStream os;
    os.precision(digits);
    for (direction cmpt = 0; cmpt < vector::nComponents; ++cmpt)
    {
        if (isStill_[cmpt] && momentum_[cmpt] > 0)
        {
            os  << "; not compared, because nothing flows along it: " << UName_
                << vector::componentNames[cmpt] << ' ' << momentum_[cmpt]
                << " (at most " << fraction_[cmpt]
                << " of the largest velocity component)";
        }
    }
    return os.str();
}


Foam::string Foam::residualCriteria::remedy(const bool converged) const
{
    bool isPressure = false;
    bool isFluid = false;
    for (const compared& c : compareAll())
    {
        const bool ofPressure = c.name == "p" || c.name == "p_rgh";
        isPressure = isPressure || (!c.isMet && ofPressure);
        isFluid = isFluid || (!c.isMet && !ofPressure);
    }
    string text;
    if (isPressure)
    {
        text +=
            ". Remove the pressure from residualControl: its entry is that of "
            "the last inner solution";
    }
    if (isFluid)
    {
        text += pimple_.consistent() ? "" : ". Set 'consistent yes'";
        text +=
            ". See that the solvers' tolerances are below those of "
            "residualControl";
    }
    if (!converged)
    {
        text +=
            ". Choose another acceleration in the structure's case file; its "
            "criteria are those of 'coupling.convergence', the change of the "
            "force among them";
    }
    return text;
}


// ************************************************************************* //
