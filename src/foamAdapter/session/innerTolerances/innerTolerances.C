// SPDX-License-Identifier: GPL-3.0-or-later
#include "innerTolerances.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

const Foam::Enum<Foam::innerTolerances::choice>
Foam::innerTolerances::choiceNames
({
    {choice::fixed, "fixed"},
    {choice::tied, "tied"}
});

namespace
{

//- Of the last pressure correction, in pimpleFoam and in its relatives
const Foam::wordList names({"pFinal", "p_rghFinal"});

//- Least relative tolerance before the final corrector. The residual that it is
//  relative to falls from corrector to corrector with that of the coupling.
constexpr Foam::scalar loose = 0.1;

} // End anonymous namespace

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::innerTolerances::choice Foam::innerTolerances::readChoice
(
    const dictionary& dict
)
{
    const word name
    (
        dict.getOrDefault<word>("innerTolerances", choiceNames[choice::fixed])
    );
    if (!choiceNames.found(name))
    {
        FatalIOErrorInFunction(dict)
            << "'innerTolerances' is '" << name << "': it can be "
            << choiceNames[choice::fixed] << " or "
            << choiceNames[choice::tied] << exit(FatalIOError);
    }
    return choiceNames[name];
}


Foam::dictionary* Foam::innerTolerances::solvers(const word& name) const
{
    const dictionary* const present =
        mesh_.solutionDict().findDict("solvers");

    if (!present || !present->findDict(name, keyType::REGEX))
    {
        return nullptr;
    }
    // OpenFOAM solves by a private copy of the dictionary, and reads it anew
    // in each solution
    return const_cast<dictionary*>(&mesh_.solverDict(name).parent());
}


void Foam::innerTolerances::loosen()
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
        if (solver.getOrDefault<scalar>("relTol", 0) < loose)
        {
            const entry* const own = all->findEntry(name, keyType::LITERAL);
            own_.set(name, own ? own->clone().ptr() : nullptr);
            solver.set("relTol", loose);
            // Not set(), which would empty the pattern
            all->remove(name);
            all->add(name, solver);
        }
    }
}


void Foam::innerTolerances::restore()
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

Foam::innerTolerances::innerTolerances
(
    const dictionary& dict,
    const fvMesh& mesh
)
:
    mesh_(mesh),
    choice_(readChoice(dict))
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::innerTolerances::announce() const
{
    if (choice_ == choice::tied)
    {
        Info<< "    until the final corrector of a step the pressure is solved "
            << "to relTol " << loose << " (innerTolerances tied)" << endl;
    }
}


void Foam::innerTolerances::beginCorrector(const bool final)
{
    if (final)
    {
        restore();
    }
    else if (choice_ == choice::tied)
    {
        loosen();
    }
}


// ************************************************************************* //
