// SPDX-License-Identifier: GPL-3.0-or-later
#include "laplaceEquation.H"
#include "fvMatrix.H"

#include <algorithm>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- Error of a field in the energy norm, relative to the field. The mesh is the
//  same on any number of ranks to ten times that; its quality has six digits
constexpr scalar energyTolerance = 1e-6;

//- Enough for non-orthogonal meshes
constexpr label maxIterations = 100;

//- Sums over the cells of all ranks of the products of two fields
static scalarBlock dot(const List<floatBlock>& a, const List<floatBlock>& b)
{
    scalarBlock sums{};
    forAll(a, row)
    {
        scalarBlock factors;
        factors.set(1, a[row]);
        sums.add(factors, b[row]);
    }
    if (Pstream::parRun())
    {
        scalarField all(UList<scalar>(sums.values, blockSize));
        reduce(all, sumOp<scalarField>());
        std::copy(all.begin(), all.end(), sums.values);
    }
    return sums;
}

//- Zero where the denominator is: the field is zero
static scalarBlock ratio(const scalarBlock& a, const scalarBlock& b)
{
    scalarBlock result;
    for (label i = 0; i < blockSize; ++i)
    {
        result[i] = mag(b[i]) > ROOTVSMALL ? a[i]/b[i] : 0;
    }
    return result;
}

//- p = r + beta (p - omega v)
static void setDirection
(
    const scalarBlock& beta,
    const scalarBlock& omega,
    const List<floatBlock>& r,
    const List<floatBlock>& v,
    List<floatBlock>& p
)
{
    floatBlock factor, minusOmega;
    factor.set(1, beta);
    minusOmega.set(-1, omega);
    forAll(p, row)
    {
        p[row].add(minusOmega, v[row]);
        p[row].multiply(factor);
        p[row].add(1, r[row]);
    }
}

//- Add to fields a multiple of others, whose part of the residual goes
static void step
(
    const scalarBlock& factor,
    const List<floatBlock>& direction,
    const List<floatBlock>& ofDirection,
    List<scalarBlock>& x,
    List<floatBlock>& residual
)
{
    floatBlock minusFactor;
    minusFactor.set(-1, factor);
    forAll(x, row)
    {
        x[row].add(factor, direction[row]);
        residual[row].add(minusFactor, ofDirection[row]);
    }
}

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::laplaceEquation::setRows(const fvScalarMatrix& equation)
{
    const labelUList& owner = equation.lduAddr().lowerAddr();
    const labelUList& neighbour = equation.lduAddr().upperAddr();
    const scalarField& upper = equation.upper();
    const label nRows = equation.lduAddr().size();
    sparseRows& rows = matrix_.offDiagonal;
    rows.starts = List<label>(nRows + 1, Zero);
    rows.columns.setSize(2*upper.size());
    rows.values.setSize(2*upper.size());
    matrix_.diagonal = scalarField(nRows, Zero);
    forAll(upper, facei)
    {
        ++rows.starts[owner[facei] + 1];
        ++rows.starts[neighbour[facei] + 1];
    }
    for (label row = 0; row < nRows; ++row)
    {
        rows.starts[row + 1] += rows.starts[row];
    }
    labelList next(rows.starts);
    const auto append = [&](const label row, const label column, const float k)
    {
        rows.columns[next[row]] = column;
        rows.values[next[row]++] = -k;
        // Of what the floats are, so that a constant field has no flux
        matrix_.diagonal[row] += k;
    };
    forAll(upper, facei)
    {
        append(neighbour[facei], owner[facei], upper[facei]);
    }
    matrix_.uppers = next;
    forAll(upper, facei)
    {
        append(owner[facei], neighbour[facei], upper[facei]);
    }
}


void Foam::laplaceEquation::setPatches(const fvScalarMatrix& equation)
{
    const fvMesh& mesh = equation.psi().mesh();
    fixedCoeffs_ = scalarField(mesh.nBoundaryFaces(), Zero);
    faceValues_ = List<float>(faces_.size(), float(0));
    forAll(mesh.boundary(), patchi)
    {
        const fvPatch& patch = mesh.boundary()[patchi];
        // Not where the coordinate along a cyclic's period is given
        const bool isCoupled = equation.psi().boundaryField()[patchi].coupled();
        const scalarField& inCells = equation.internalCoeffs()[patchi];
        forAll(patch, facei)
        {
            const float coeff = -inCells[facei];
            matrix_.diagonal[patch.faceCells()[facei]] += coeff;
            if (isCoupled)
            {
                faceValues_[faces_.start(patchi) + facei] = -coeff;
            }
            else
            {
                fixedCoeffs_
                    [patch.start() - mesh.nInternalFaces() + facei] = coeff;
            }
        }
    }

    const label nFaces = faces_.size();
    sparseRows& atFaces = matrix_.atFaces;
    atFaces.starts = identity(nFaces + 1);
    atFaces.columns = faces_.cells();
    atFaces.values = List<float>(nFaces, float(1));
    matrix_.fromFaces = atFaces.transposed(matrix_.diagonal.size());
}


void Foam::laplaceEquation::apply
(
    const List<floatBlock>& x,
    List<floatBlock>& y
) const
{
    forAll(y, row)
    {
        // What neighbours have in common cancels
        scalarBlock sum;
        sum.set(matrix_.diagonal[row], x[row]);
        matrix_.offDiagonal.addProduct(row, scalar(1), x, sum);
        y[row].set(1, sum);
    }
    if (faces_.any())
    {
        const labelList& cells = faces_.cells();
        const List<floatBlock> own(x, cells);
        const List<floatBlock> beyond(faces_.beyond(own));
        forAll(cells, face)
        {
            y[cells[face]].add(faceValues_[face], beyond[face]);
        }
    }
    if (fluxes_)
    {
        fluxes_->subtract(x, fixedCoeffs_, faceValues_, List<scalarBlock>(), y);
    }
}


Foam::List<Foam::floatBlock> Foam::laplaceEquation::source
(
    const List<scalarBlock>& onFaces
) const
{
    List<floatBlock> b(matrix_.diagonal.size(), floatBlock{});
    if (fluxes_)
    {
        // What flows out of the cells
        const List<floatBlock> none(b.size(), floatBlock{});
        fluxes_->subtract(none, fixedCoeffs_, faceValues_, onFaces, b);
        for (floatBlock& block : b)
        {
            block.multiply(-1);
        }
    }
    forAll(fixedCoeffs_, face)
    {
        b[faceCells_[face]].add(fixedCoeffs_[face], onFaces[face]);
    }
    return b;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::laplaceEquation::laplaceEquation
(
    const fvScalarMatrix& equation,
    const coupledFaces& faces,
    const nonOrthogonalFluxes* fluxes
)
:
    faces_(faces),
    fluxes_(fluxes),
    faceCells_
    (
        SubList<label>
        (
            equation.psi().mesh().faceOwner(),
            equation.psi().mesh().nBoundaryFaces(),
            equation.psi().mesh().nInternalFaces()
        )
    )
{
    setRows(equation);
    setPatches(equation);
    multigrid_.reset(new extensionMultigrid(matrix_, faces_, faceValues_));
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::List<Foam::scalarBlock> Foam::laplaceEquation::solve
(
    const List<scalarBlock>& onFaces
)
{
    List<floatBlock> r(source(onFaces));
    const List<floatBlock> shadow(r);
    List<scalarBlock> x(r.size(), scalarBlock{});
    List<floatBlock> p(r.size(), floatBlock{}), v(p), t(r.size());
    scalarBlock rho{}, alpha{}, omega{}, allowed{}, isOpen;
    std::fill_n(isOpen.values, blockSize, 1);
    label pass = 0;
    for (; pass < maxIterations && isOpen.isAny(); ++pass)
    {
        scalarBlock beta(ratio(alpha, omega));
        beta.multiply(ratio(isOpen, rho));
        rho = dot(r, shadow);
        beta.multiply(rho);
        setDirection(beta, omega, r, v, p);
        const List<floatBlock>& z = multigrid_->precondition(p);
        if (pass == 0)
        {
            allowed.set(sqr(energyTolerance), dot(p, z));
        }
        apply(z, v);
        alpha = ratio(rho, dot(v, shadow));
        alpha.multiply(isOpen);
        step(alpha, z, v, x, r);

        multigrid_->precondition(r);
        const scalarBlock energy(dot(r, z));
        apply(z, t);
        omega = ratio(dot(t, r), dot(t, t));
        omega.multiply(isOpen);
        step(omega, z, t, x, r);
        for (label i = 0; i < blockSize; ++i)
        {
            // NaN stays open
            isOpen[i] = !(energy[i] <= allowed[i]);
        }
    }
    if (isOpen.isAny())
    {
        WarningInFunction
            << "extensions of the boundary's motion have not converged in "
            << pass << " iterations: the mesh may be worse than it could be."
            << nl << "    See what checkMesh finds; where faces are very"
            << " non-orthogonal, set" << nl
            << "    laplacian(diffusivity,cellDisplacement) in fvSchemes to"
            << " Gauss linear uncorrected" << nl << endl;
    }
    return x;
}


// ************************************************************************* //
