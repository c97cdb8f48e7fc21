// SPDX-License-Identifier: GPL-3.0-or-later
#include "couplingInterface.H"
#include "globalIndex.H"
#include "globalMeshData.H"
#include "indirectPrimitivePatch.H"
#include "ListListOps.H"
#include "openfoamVersion.H"
#include "points0MotionSolver.H"

#include <sstream>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::couplingInterface::setDimension()
{
    const Vector<label>& geometric = mesh_.geometricD();
    const Vector<label>& solved = mesh_.solutionD();

    if (geometric != solved)
    {
        FatalIOErrorInFunction(dict_)
            << "the mesh has wedge patches: axisymmetric scenes cannot be "
            << "coupled; use a 2D or a 3D mesh" << exit(FatalIOError);
    }
    for (direction cmpt = 0; cmpt < vector::nComponents; ++cmpt)
    {
        if (geometric[cmpt] == 1)
        {
            components_.append(cmpt);
        }
        else
        {
            depth_ *= mesh_.bounds().span()[cmpt];
        }
    }
    if (components_.size() < 2)
    {
        FatalIOErrorInFunction(dict_)
            << "the mesh has more than one empty direction" << nl
            << "    use a 2D or a 3D mesh" << exit(FatalIOError);
    }
}


void Foam::couplingInterface::gather(pointField& points, faceList& faces)
{
    // Not the mesh's own points, which are displaced after a restart
    const pointIOField points0(points0MotionSolver::points0IO(mesh_));

    label nFaces = 0;
    for (const label patchi : patches_)
    {
        nFaces += mesh_.boundary()[patchi].size();
    }

    labelList meshFaces(nFaces);
    nFaces = 0;
    for (const label patchi : patches_)
    {
        const polyPatch& patch = mesh_.boundaryMesh()[patchi];
        forAll(patch, facei)
        {
            meshFaces[nFaces++] = patch.start() + facei;
        }
    }
    nLocalFaces_ = nFaces;
    nFaces_ = returnReduce(nFaces, sumOp<label>());

    const indirectPrimitivePatch surface
    (
        IndirectList<face>(mesh_.faces(), meshFaces),
        points0
    );
    labelList pointToGlobal;
    labelList uniqueMeshPoints;
    mesh_.globalData().mergePoints
    (
        surface.meshPoints(),
        surface.meshPointMap(),
        pointToGlobal,
        uniqueMeshPoints
    );

    patchPoints_.setSize(patches_.size());
    forAll(patches_, i)
    {
        const labelList& meshPoints =
            mesh_.boundaryMesh()[patches_[i]].meshPoints();

        patchPoints_[i].setSize(meshPoints.size());
        forAll(meshPoints, pointi)
        {
            patchPoints_[i][pointi] =
                pointToGlobal[surface.meshPointMap()[meshPoints[pointi]]];
        }
    }

    faceList localFaces(surface.localFaces());
    for (face& f : localFaces)
    {
        inplaceRenumber(pointToGlobal, f);
    }

    List<pointField> allPoints(Pstream::nProcs());
    List<faceList> allFaces(Pstream::nProcs());
    allPoints[Pstream::myProcNo()] =
        pointField(points0, uniqueMeshPoints);
    allFaces[Pstream::myProcNo()] = localFaces;
    Pstream::gatherList(allPoints);
    Pstream::gatherList(allFaces);

    if (Pstream::master())
    {
        points = ListListOps::combine<pointField>
        (
            allPoints, accessOp<pointField>()
        );
        faces = ListListOps::combine<faceList>
        (
            allFaces, accessOp<faceList>()
        );
    }
}


std::string Foam::couplingInterface::reduceToPlane
(
    pointField& points,
    faceList& faces,
    labelList& partner
) const
{
    const direction normal = emptyDirection();
    const scalar middle =
        0.5*(mesh_.bounds().min()[normal] + mesh_.bounds().max()[normal]);

    partner.setSize(points.size(), label(-1));
    DynamicList<point> planePoints;
    forAll(points, pointi)
    {
        if (points[pointi][normal] < middle)
        {
            partner[pointi] = planePoints.size();
            planePoints.append(points[pointi]);
        }
    }

    for (face& f : faces)
    {
        face edge(2);
        label nInPlane = 0;
        forAll(f, fp)
        {
            const label next = f.nextLabel(fp);
            const bool inPlane = points[f[fp]][normal] < middle;
            if (inPlane && points[next][normal] < middle)
            {
                edge[0] = partner[f[fp]];
                edge[1] = partner[next];
            }
            nInPlane += inPlane;
            if (!inPlane && points[next][normal] < middle)
            {
                partner[f[fp]] = partner[next];
            }
            if (inPlane && !(points[next][normal] < middle))
            {
                partner[next] = partner[f[fp]];
            }
        }
        if (f.size() != 4 || nInPlane != 2)
        {
            std::ostringstream where;
            const point centre(f.centre(points));
            where << '(' << centre.x() << ' ' << centre.y() << ' '
                << centre.z() << ')';
            return
                "a coupled face of the 2D mesh near " + where.str()
              + " does not span the empty direction: each must have two "
                "points in each of the two empty planes";
        }
        if (normal == vector::Y)
        {
            edge.flip(); // x and z are left-handed seen against y
        }
        f = edge;
    }
    points = planePoints;

    return std::string();
}


std::vector<double> Foam::couplingInterface::components
(
    const UList<vector>& field
) const
{
    std::vector<double> values;
    values.reserve(field.size()*components_.size());
    for (const vector& v : field)
    {
        for (const direction cmpt : components_)
        {
            values.push_back(v[cmpt]);
        }
    }
    return values;
}


Foam::vectorField Foam::couplingInterface::rankValues
(
    const std::vector<double>& values,
    const label rank
) const
{
    vectorField field(rankPoints_[rank].size(), Zero);
    forAll(field, i)
    {
        const label row = rankPoints_[rank][i]*components_.size();
        forAll(components_, c)
        {
            field[i][components_[c]] = values[row + c];
        }
    }
    return field;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::couplingInterface::couplingInterface
(
    const fvMesh& mesh,
    const labelList& patches,
    const dictionary& dict
)
:
    mesh_(mesh),
    dict_(dict),
    patches_(patches),
    depth_(1),
    nLocalFaces_(0),
    nFaces_(0),
    nPoints_(0)
{
    setDimension();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::couplingInterface::describe
(
    const pointVectorField& displacement,
    tokay::channel::Interface& message
)
{
    pointField points;
    faceList faces;
    gather(points, faces);

    // The displacement in the same numbering
    List<labelList> rankNumbers(Pstream::nProcs());
    List<vectorField> rankValues(Pstream::nProcs());
    rankNumbers[Pstream::myProcNo()] =
        ListListOps::combine<labelList>
        (
            patchPoints_, accessOp<labelList>()
        );
    DynamicList<vector> values;
    for (const label patchi : patches_)
    {
        values.append
        (
            displacement.boundaryField()[patchi].patchInternalField()()
        );
    }
    rankValues[Pstream::myProcNo()] = vectorField(values);
    Pstream::gatherList(rankNumbers);
    Pstream::gatherList(rankValues);

    labelList number(identity(points.size()));
    string error;
    if (components_.size() == 2 && Pstream::master())
    {
        error = reduceToPlane(points, faces, number);
    }
    fromMaster(error);
    if (!error.empty())
    {
        FatalIOErrorInFunction(dict_) << error.c_str() << exit(FatalIOError);
    }
    if (!Pstream::master())
    {
        return;
    }

    nPoints_ = points.size();

    vectorField moved(nPoints_, Zero);
    rankPoints_ = rankNumbers;
    forAll(rankPoints_, rank)
    {
        inplaceRenumber(number, rankPoints_[rank]);
        UIndirectList<vector>(moved, rankPoints_[rank]) = rankValues[rank];
    }
    message.dimension = components_.size();
    message.points = components(points);
    message.displacements = components(moved);
    message.faceOffsets.assign(1, 0);
    message.facePoints.clear();
    for (const face& f : faces)
    {
        message.facePoints.insert(message.facePoints.end(), f.begin(), f.end());
        message.faceOffsets.push_back(message.facePoints.size());
    }
}


std::vector<double> Foam::couplingInterface::collect
(
    const UList<vector>& forces
) const
{
    List<vectorField> all(Pstream::nProcs());
    all[Pstream::myProcNo()] = forces;
    Pstream::gatherList(all);

    if (!Pstream::master())
    {
        return {};
    }
    return components
    (
        vectorField
        (
            ListListOps::combine<vectorField>
            (
                all, accessOp<vectorField>()
            )/depth_
        )
    );
}


void Foam::couplingInterface::removeEmptyDirection
(
    vector& force,
    vector& moment
) const
{
    if (components_.size() == 2)
    {
        const direction normal = emptyDirection();
        const scalar kept = moment[normal];
        force[normal] = 0;
        moment = Zero;
        moment[normal] = kept;
    }
}


Foam::vector Foam::couplingInterface::force
(
    const std::array<double, 3>& sent
) const
{
    vector result(Zero);
    forAll(components_, c)
    {
        result[components_[c]] = depth_*sent[c];
    }
    return result;
}


Foam::vector Foam::couplingInterface::moment
(
    const std::array<double, 3>& sent
) const
{
    if (components_.size() == 3)
    {
        return vector(sent[0], sent[1], sent[2]);
    }
    vector result(Zero);
    const direction normal = emptyDirection();
    result[normal] = (normal == vector::Y ? -depth_ : depth_)*sent[2];
    return result;
}


Foam::List<Foam::vectorField> Foam::couplingInterface::distribute
(
    const std::vector<double>& values
) const
{
    // Not scatterList, which leaves out what belongs to the receiver
    vectorField own;
    if (Pstream::master())
    {
        own = rankValues(values, Pstream::masterNo());
        for (label rank = 1; rank < Pstream::nProcs(); ++rank)
        {
            OPstream toRank(Pstream::commsTypes::scheduled, rank);
            toRank << rankValues(values, rank);
        }
    }
    else
    {
        IPstream stream
        (
            Pstream::commsTypes::scheduled,
            Pstream::masterNo()
        );
        stream >> own;
    }

    List<vectorField> patchValues(patches_.size());
    label start = 0;
    forAll(patches_, i)
    {
        const label size = patchPoints_[i].size();
        patchValues[i] = SubField<vector>(own, size, start);
        start += size;
    }
    return patchValues;
}


// ************************************************************************* //
