// SPDX-License-Identifier: GPL-3.0-or-later
#include "dictionaryChecks.H"
#include "FlatOutput.H"

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::requireKnownEntries(const dictionary& dict, const wordList& known)
{
    for (const entry& e : dict)
    {
        if (!known.found(e.keyword()))
        {
            FatalIOErrorInFunction(dict)
                << "unknown entry '" << e.keyword() << "'; there are: "
                << flatOutput(known) << exit(FatalIOError);
        }
    }
}


// ************************************************************************* //
