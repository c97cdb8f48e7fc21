// SPDX-License-Identifier: GPL-3.0-or-later
#include "couplingPreset.H"
#include "StringStream.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

const tokay::CouplingPreset* Foam::couplingPreset::find(const dictionary& dict)
{
    if (!dict.found("preset"))
    {
        return nullptr;
    }
    const word name(dict.get<word>("preset"));
    const tokay::CouplingPreset* const found = tokay::findCouplingPreset(name);
    if (!found)
    {
        string names;
        for (const tokay::CouplingPreset& preset : tokay::couplingPresets())
        {
            names += (names.empty() ? "" : ", ") + preset.name;
        }
        FatalIOErrorInFunction(dict)
            << "preset: " << name << "; allowed: " << names.c_str()
            << exit(FatalIOError);
    }
    return found;
}


void Foam::couplingPreset::completeFunctionObject()
{
    for (const tokay::PresetEntry& e : preset_->functionObject)
    {
        if (!dict_.found(e.name))
        {
            dict_.merge
            (
                dictionary(IStringStream(e.name + ' ' + e.value + ';')())
            );
            set_.push_back(e);
        }
    }
}


void Foam::couplingPreset::findControls(const word& couplingName)
{
    const dictionary given
    (
        pimple_.dict().subOrEmptyDict("residualControl")
    );
    for
    (
        const word& name
      : {couplingName, dict_.getOrDefault<word>("U", "U")}
    )
    {
        if (!given.found(name, keyType::REGEX))
        {
            dictionary control;
            control.add
            (
                "tolerance",
                readScalar(preset_->tolerance)
            );
            control.add("relTol", 0);
            controls_.add(name, control);
            set_.push_back
            ({
                "residualControl." + name + ".tolerance", preset_->tolerance
            });
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::couplingPreset::couplingPreset
(
    const word& couplingName,
    const fvMesh& mesh,
    const pimpleControl& pimple,
    const dictionary& dict
)
:
    mesh_(mesh),
    pimple_(pimple),
    preset_(find(dict)),
    dict_(dict)
{
    if (preset_)
    {
        // An explicit coupling has nothing to converge
        if (pimple.nCorrPIMPLE() > 1)
        {
            findControls(couplingName);
        }
        completeFunctionObject();
        completeControls();
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::couplingPreset::announce() const
{
    if (preset_)
    {
        Info<< "    " << tokay::describePreset(preset_->name, set_).c_str()
            << endl;
    }
}


void Foam::couplingPreset::completeControls() const
{
    if (controls_.empty())
    {
        return;
    }
    // PIMPLE reads its dictionary before each outer corrector
    dictionary& controls =
        const_cast<dictionary&>(mesh_.solutionDict()).subDict
        (
            pimple_.dict().dictName()
        );
    if (!controls.found("residualControl"))
    {
        controls.add("residualControl", dictionary());
    }
    dictionary& residualControl = controls.subDict("residualControl");
    for (const entry& e : controls_)
    {
        if (!residualControl.found(e.keyword(), keyType::REGEX))
        {
            residualControl.add(e);
        }
    }
}


// ************************************************************************* //
