// SPDX-License-Identifier: GPL-3.0-or-later
#include "sampleMeshes.hpp"

#include <cmath>

namespace tokay::mapper {

namespace {

Points shakenGrid(int nX, int nY, double sizeX, double sizeY, int seed) {
    Points vertices((nX + 1) * (nY + 1), 3);
    for (int j = 0; j <= nY; ++j) {
        for (int i = 0; i <= nX; ++i) {
            const int number = i + (nX + 1) * j;
            const double shakeX = i == 0 || i == nX ? 0 : 0.2 * std::sin(7.3 * number + seed);
            const double shakeY = j == 0 || j == nY ? 0 : 0.2 * std::cos(5.1 * number - seed);
            vertices.row(number) << sizeX * (i + shakeX) / nX, sizeY * (j + shakeY) / nY, 0;
        }
    }
    return vertices;
}

} // namespace

SurfaceMesh flatMesh(int nX, int nY, FaceKind kind, ValuesAt valuesAt, double sizeX, double sizeY,
                     int seed) {
    SurfaceMesh::Faces faces;
    for (int j = 0; j < nY; ++j) {
        for (int i = 0; i < nX; ++i) {
            const int a = i + (nX + 1) * j, b = a + 1, c = b + nX + 1, d = a + nX + 1;
            if (kind == FaceKind::triangles) {
                faces.push_back({a, b, c});
                faces.push_back({a, c, d});
            } else if (kind == FaceKind::polygons && i + 1 < nX) {
                faces.push_back({a, b, b + 1, c + 1, c, d});
                ++i;
            } else {
                faces.push_back({a, b, c, d});
            }
        }
    }
    return SurfaceMesh(shakenGrid(nX, nY, sizeX, sizeY, seed), faces, valuesAt);
}

} // namespace tokay::mapper
