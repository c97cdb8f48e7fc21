// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/kinematics/OutputOptions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstring>
#include <set>

namespace tokay::structure {

const SchemaOf<OutputOptions>& OutputOptions::schema() {
    static const Choices<CellShape> shapes = {
        {"quads", CellShape::quads,
         "each element cut into subdivision x subdivision flat cells (a solid: subdivision^3 "
         "hexahedra), for any reader."},
        {"bezier", CellShape::bezier,
         "one exact (rational) Bezier cell per element (of a beam its axis), for ParaView 5.8 or "
         "later."}};
    static const SchemaOf<OutputOptions> schema = {
        {"directory", &OutputOptions::directory,
         "Directory of the .pvd and .vtu files, relative to the case file."},
        {"interval", &OutputOptions::interval, "[0, inf)", "time steps",
         "Run alone: time steps between two results; 0: none. A coupled run writes when the fluid "
         "writes."},
        {"fields", &OutputOptions::fields,
         "Fields of the .vtu files. Every body has displacement, velocity and acceleration; a "
         "plane solid and a solid stress (Cauchy), vonMisesStress and principalStress [Pa, "
         "descending]; a beam or cable normalForce [N], bendingMoment [N m], shearForce [N] (in "
         "space their magnitudes) and axialStress; a shell or membrane membraneForce [N/m] and "
         "bendingMoment [N] (11, 22, 12; axis 1 along the first parameter line), "
         "principalStressTop and principalStressBottom [Pa, descending] at its faces, top being "
         "where the normal points.",
         otherwise("displacement, velocity and stress or stress resultants")},
        {"cells", &OutputOptions::cells, shapes, "Cells of the .vtu files."},
        {"subdivision", &OutputOptions::subdivision, "[1, 100]", "",
         "quads: cells along each side of an element (one through the thickness of a beam; a line "
         "in space has pieces of its axis)."},
        {"watchPoints", &OutputOptions::watchPoints,
         "Points whose displacement is tabulated in each time step; the first one is shown in the "
         "log.",
         otherwise("`[]`")},
        {"reactionsAbout", &OutputOptions::reactionsAbout, "", "m",
         "Tabulates in each time step the force and the moment about this point by which each "
         "support acts on the body (reactions.dat).",
         otherwise("no table")}};
    return schema;
}

void OutputOptions::requireValid() const {
    std::set<std::string> names;
    for (const WatchPoint& point : watchPoints) {
        const std::string& name = point.name;
        const bool isUsable =
            !name.empty() && std::none_of(name.begin(), name.end(), [](unsigned char c) {
                return std::iscntrl(c) || std::isspace(c) || std::strchr("#[]\"", c);
            });
        if (!isUsable) {
            throw point.error("name", fmt::format("'{}' cannot name columns of a table; leave out "
                                                  "white space, '#', '\"', '[' and ']'",
                                                  shortened(name)));
        }
        if (!names.insert(name).second) {
            throw point.error("name", fmt::format("'{}' is the name of two watch points; give each "
                                                  "its own",
                                                  name));
        }
    }
}

} // namespace tokay::structure
