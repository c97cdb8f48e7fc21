// SPDX-License-Identifier: GPL-3.0-or-later
#include "pressureTolerance.H"
#include "dictionaryChecks.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

const Foam::Enum<Foam::pressureTolerance::choice>
Foam::pressureTolerance::choiceNames
({
    {choice::fixed, "fixed"},
    {choice::relaxed, "relaxed"}
});

namespace
{

//- Solvers of the last pressure corrector, in pimpleFoam and its relatives
const Foam::wordList names({"pFinal", "p_rghFinal"});

//- Relative tolerance before the final outer corrector. The residual that it is
//  relative to falls with the coupling residual.
constexpr Foam::scalar relaxedRelTol = 0.1;

} // End anonymous namespace

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::dictionary* Foam::pressureTolerance::solvers(const word& name) const
{
    const dictionary* const present =
        mesh_.solutionDict().findDict("solvers");

    if (!present || !present->findDict(name, keyType::REGEX))
    {
        return nullptr;
    }
    // OpenFOAM solves with a private copy of the dictionary, which it reads
    // before each solution
    return const_cast<dictionary*>(&mesh_.solverDict(name).parent());
}


void Foam::pressureTolerance::relax()
{
    for (const word& name : names)
    {
        dictionary* const all = solvers(name);
        if (!all)
        {
            continue;
        }
        // What the name matches may be a pattern, which other solvers share
        dictionary solver(all->subDict(name));
        if (solver.getOrDefault<scalar>("relTol", 0) < relaxedRelTol)
        {
            const entry* const own = all->findEntry(name, keyType::LITERAL);
            own_.set(name, own ? own->clone().ptr() : nullptr);
            solver.set("relTol", relaxedRelTol);
            // Not set(), which would empty the pattern
            all->remove(name);
            all->add(name, solver);
        }
    }
}


void Foam::pressureTolerance::restore()
{
    forAllIters(own_, iter)
    {
        if (dictionary* const all = solvers(iter.key()))
        {
            all->remove(iter.key());
            if (iter.val())
            {
                all->add(iter.val()->clone(*all).ptr());
            }
        }
    }
    own_.clear();
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::pressureTolerance::pressureTolerance
(
    const dictionary& dict,
    const fvMesh& mesh
)
:
    mesh_(mesh),
    choice_
    (
        readChoice("pressureTolerance", dict, choiceNames, choice::relaxed)
    )
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::pressureTolerance::announce() const
{
    if (choice_ == choice::relaxed)
    {
        Info<< "    pressureTolerance relaxed: relTol " << relaxedRelTol
            << " until the final outer corrector" << endl;
    }
}


void Foam::pressureTolerance::beginCorrector(const bool final)
{
    if (final)
    {
        restore();
    }
    else if (choice_ == choice::relaxed)
    {
        relax();
    }
}


// ************************************************************************* //
