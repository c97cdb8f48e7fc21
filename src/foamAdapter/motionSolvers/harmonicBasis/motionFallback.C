// SPDX-License-Identifier: GPL-3.0-or-later
#include "motionFallback.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool Foam::motionFallback::readWanted() const
{
    const word wanted
    (
        coeffs_.getOrDefault<word>("fallback", "displacementLaplacian")
    );
    if (wanted != "displacementLaplacian" && wanted != "none")
    {
        FatalIOErrorInFunction(coeffs_)
            << "unknown 'fallback' " << wanted
            << "; there are: displacementLaplacian none"
            << exit(FatalIOError);
    }
    return wanted != "none";
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::motionFallback::motionFallback
(
    const dictionary& coeffs,
    dictionary& state,
    pointVectorField& pointDisplacement,
    const string& diffusivity
)
:
    coeffs_(coeffs),
    state_(state),
    pointDisplacement_(pointDisplacement),
    diffusivity_(diffusivity),
    wanted_(readWanted()),
    sweeps_
    (
        coeffs.getCheckOrDefault<label>
        (
            "fallbackSweeps",
            60,
            labelMinMax::ge(1)
        )
    )
{
    if (state.found("fallbackReason"))
    {
        begin(state.get<string>("fallbackReason"));
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::motionFallback::begin(const string& reason)
{
    if (!wanted_)
    {
        FatalIOErrorInFunction(coeffs_)
            << "harmonicBasis cannot move the mesh, because" << nl
            << "    " << reason.c_str() << nl
            << "    With 'fallback displacementLaplacian' the run would go on"
            << exit(FatalIOError);
    }
    Info<< "harmonicBasis: the mesh moves as by displacementLaplacian with "
        << sweeps_ << " sweeps from here on, because" << nl
        << "    " << reason.c_str() << nl << endl;
    state_.set("fallbackReason", reason);
    motion_.reset
    (
        new laplacianMotion(pointDisplacement_, diffusivity_, sweeps_)
    );
}


// ************************************************************************* //
