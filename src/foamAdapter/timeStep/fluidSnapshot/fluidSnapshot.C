// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluidSnapshot.H"
#include "crankNicolsonRates.H"
#include "pointFields.H"
#include "surfaceFields.H"
#include "volFields.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class GeoField>
void Foam::fluidSnapshot::save
(
    std::vector<std::unique_ptr<savedField>>& saved
)
{
    for (const word& name : mesh_.sortedNames<GeoField>())
    {
        // Old times are saved with their field. Those of a rate are there for
        // its time index, by which the repeated step evaluates it again
        const bool isRate = crankNicolsonRates::isRate(name);
        if (isRate || !name.ends_with("_0"))
        {
            saved.emplace_back
            (
                new savedFieldOf<GeoField>
                (
                    mesh_.lookupObjectRef<GeoField>(name),
                    !isRate
                )
            );
        }
    }
}


template<class Type>
void Foam::fluidSnapshot::saveAll()
{
    save<GeometricField<Type, pointPatchField, pointMesh>>(pointFields_);
    save<GeometricField<Type, fvPatchField, volMesh>>(fields_);
    save<GeometricField<Type, fvsPatchField, surfaceMesh>>(fields_);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fluidSnapshot::fluidSnapshot(const fvMesh& mesh)
:
    mesh_(const_cast<fvMesh&>(mesh)),
    points_(mesh.points())
{
    saveAll<scalar>();
    saveAll<vector>();
    saveAll<sphericalTensor>();
    saveAll<symmTensor>();
    saveAll<tensor>();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fluidSnapshot::restore()
{
    mesh_.movePoints(points_);
    for (const auto& field : pointFields_)
    {
        field->restore();
    }
    restoreFields();
}


void Foam::fluidSnapshot::restoreFields()
{
    for (const auto& field : fields_)
    {
        field->restore();
    }
}


// ************************************************************************* //
