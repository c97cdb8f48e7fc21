// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/case/kinematicsTypes.hpp"

#include "igaStructure/kinematics/beam/BeamEntries.hpp"
#include "igaStructure/kinematics/plane/PlaneEntries.hpp"
#include "igaStructure/kinematics/shell/ShellEntries.hpp"
#include "igaStructure/kinematics/solid/SolidEntries.hpp"

namespace tokay::structure {

namespace {

template <class Description>
StructureCase asCase(Description description) {
    return description;
}
StructureCase asCase(const PlaneCase& either) {
    return std::visit([](const auto& one) -> StructureCase { return one; }, either);
}

template <class Entries, class Description>
class EntriesOf : public BodyEntries {
  public:
    using Make = Description (*)(const Entries&, const CaseContext&);
    explicit EntriesOf(Make function) : make_(function) {}

    void* entries() override { return &entries_; }
    Coupling& coupling() override { return entries_.coupling; }
    StructureCase make(const CaseContext& context) const override {
        return asCase(make_(entries_, context));
    }

  private:
    Make make_;
    Entries entries_;
};

template <class Entries, class Description>
KinematicsType kinematics(const char* name, const char* meaning,
                          Description (*make)(const Entries&, const CaseContext&),
                          bool bendsThinly = false) {
    return {name, meaning, &Entries::schema(),
            [make] { return std::make_unique<EntriesOf<Entries, Description>>(make); },
            bendsThinly};
}

} // namespace

const std::vector<KinematicsType>& kinematicsTypes() {
    static const std::vector<KinematicsType> types = {
        kinematics("planeStrain", "Slice of a long body; forces are per unit depth.",
                   makePlaneStrain),
        kinematics("planeStress", "Thin plate in its plane.", makePlaneStress),
        kinematics("beam",
                   "Euler-Bernoulli beam without rotational unknowns, in the plane, or in space: "
                   "straight, with the same bending stiffness in all directions, without torsion.",
                   makeBeam, true),
        kinematics("cable", "Line without bending stiffness, in the plane or in space.", makeCable),
        kinematics("shell", "Kirchhoff-Love shell in space, without rotational unknowns.",
                   makeShell, true),
        kinematics("membrane", "Shell without bending stiffness.", makeMembrane),
        kinematics("solid", "Volume in space.", makeSolid)};
    return types;
}

} // namespace tokay::structure
