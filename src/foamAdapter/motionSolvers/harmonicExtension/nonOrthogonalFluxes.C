// SPDX-License-Identifier: GPL-3.0-or-later
#include "nonOrthogonalFluxes.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- A vector in floats
static FixedList<float, 3> inFloats(const vector& v)
{
    FixedList<float, 3> result;
    for (direction cmpt = 0; cmpt < vector::nComponents; ++cmpt)
    {
        result[cmpt] = v[cmpt];
    }
    return result;
}

//- In floats, without cancellation in a sum over the faces of a cell
template<class Type>
static floatBlock difference(const Type& a, const floatBlock& b)
{
    floatBlock result;
    result.set(1, a);
    result.add(-1, b);
    return result;
}

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

inline void Foam::nonOrthogonalFluxes::addToGradient
(
    blockGradient& gradient,
    const floatVector& area,
    const float weight,
    const floatBlock& step
)
{
    for (label axis = 0; axis < 3; ++axis)
    {
        gradient[axis].add(weight*area[axis], step);
    }
}


inline Foam::floatBlock Foam::nonOrthogonalFluxes::fluxOf
(
    const faceGeometry& face,
    const blockGradient& own,
    const blockGradient& other
)
{
    floatBlock flux{};
    for (label axis = 0; axis < 3; ++axis)
    {
        const float ofOwn = face.flux[axis]*face.weight;
        flux.add(ofOwn, own[axis]);
        flux.add(face.flux[axis] - ofOwn, other[axis]);
    }
    return flux;
}


const Foam::List<Foam::nonOrthogonalFluxes::blockGradient>&
Foam::nonOrthogonalFluxes::gradients
(
    const List<floatBlock>& x,
    const scalarField& fixedCoeffs,
    const List<float>& coupledCoeffs,
    const List<scalarBlock>& onFaces
) const
{
    const labelUList& owner = mesh_.faceOwner();
    const labelUList& neighbour = mesh_.faceNeighbour();
    List<blockGradient>& gradient = gradients_;
    gradient.setSize(x.size());
    gradient = blockGradient(floatBlock{});
    forAll(internal_, facei)
    {
        const faceGeometry& face = internal_[facei];
        const label own = owner[facei];
        const label other = neighbour[facei];
        const floatBlock step(difference(x[other], x[own]));
        addToGradient(gradient[own], face.area, 1 - face.weight, step);
        addToGradient(gradient[other], face.area, face.weight, step);
    }
    if (faces_.any())
    {
        const List<floatBlock> own(x, faces_.cells());
        const List<floatBlock> beyond(faces_.beyond(own));
        forAll(coupled_, facei)
        {
            if (coupledCoeffs[facei] != 0)
            {
                const faceGeometry& face = coupled_[facei];
                addToGradient
                (
                    gradient[faces_.cells()[facei]],
                    face.area,
                    1 - face.weight,
                    difference(beyond[facei], own[facei])
                );
            }
        }
    }
    const scalarBlock zero{};
    forAll(fixedCoeffs, facei)
    {
        if (fixedCoeffs[facei] != 0)
        {
            const label meshFace = mesh_.nInternalFaces() + facei;
            const label own = owner[meshFace];
            addToGradient
            (
                gradient[own],
                inFloats(mesh_.faceAreas()[meshFace]),
                1,
                difference(onFaces.empty() ? zero : onFaces[facei], x[own])
            );
        }
    }
    forAll(gradient, celli)
    {
        const float inverse = 1/mesh_.cellVolumes()[celli];
        for (floatBlock& component : gradient[celli])
        {
            component.multiply(inverse);
        }
    }
    return gradient;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::nonOrthogonalFluxes::nonOrthogonalFluxes
(
    const fvMesh& mesh,
    const coupledFaces& faces,
    const surfaceScalarField& diffusivity
)
:
    mesh_(mesh),
    faces_(faces),
    internal_(mesh.nInternalFaces()),
    coupled_(faces.size())
{
    const surfaceVectorField& corrections = mesh.nonOrthCorrectionVectors();
    const auto geometry = []
    (
        const scalar weight,
        const vector& area,
        const vector& correction,
        const scalar diffusivity
    )
    {
        return faceGeometry
        {
            float(weight),
            inFloats(area),
            inFloats(diffusivity*mag(area)*correction)
        };
    };
    forAll(internal_, facei)
    {
        internal_[facei] = geometry
        (
            mesh.weights()[facei],
            mesh.Sf()[facei],
            corrections[facei],
            diffusivity[facei]
        );
    }
    forAll(mesh.boundary(), patchi)
    {
        const label start = faces.start(patchi);
        for
        (
            label facei = 0;
            start >= 0 && facei < mesh.boundary()[patchi].size();
            ++facei
        )
        {
            coupled_[start + facei] = geometry
            (
                mesh.weights().boundaryField()[patchi][facei],
                mesh.Sf().boundaryField()[patchi][facei],
                corrections.boundaryField()[patchi][facei],
                diffusivity.boundaryField()[patchi][facei]
            );
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::nonOrthogonalFluxes::subtract
(
    const List<floatBlock>& x,
    const scalarField& fixedCoeffs,
    const List<float>& coupledCoeffs,
    const List<scalarBlock>& onFaces,
    List<floatBlock>& y
) const
{
    const List<blockGradient>& gradient =
        gradients(x, fixedCoeffs, coupledCoeffs, onFaces);
    const labelUList& owner = mesh_.faceOwner();
    const labelUList& neighbour = mesh_.faceNeighbour();
    forAll(internal_, facei)
    {
        const label own = owner[facei];
        const label other = neighbour[facei];
        const floatBlock flux
        (
            fluxOf(internal_[facei], gradient[own], gradient[other])
        );
        y[own].add(-1, flux);
        y[other].add(1, flux);
    }
    if (faces_.any())
    {
        const labelList& cells = faces_.cells();
        const List<blockGradient> own(gradient, cells);
        const List<blockGradient> beyond(faces_.beyond(own));
        forAll(coupled_, facei)
        {
            if (coupledCoeffs[facei] != 0)
            {
                y[cells[facei]].add
                (
                    -1,
                    fluxOf(coupled_[facei], own[facei], beyond[facei])
                );
            }
        }
    }
}


// ************************************************************************* //
