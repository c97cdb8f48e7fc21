// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Table.hpp"
#include "mapper/mortar/MortarMapping.hpp"

#include <functional>
#include <map>
#include <memory>

namespace tokay::benchmark {

enum Field { smooth, shock, nFields };
double valueOf(Field field, const Eigen::Vector3d& x);

/// Two sides of an interface, made for a size.
struct Setup {
    std::shared_ptr<const mapper::Discretisation> from;
    bool hasSplinesFrom;
    int nTo;
    /// Values that stand for each field.
    Eigen::VectorXd values[nFields];
    /// Where the result is compared with the field, and how values become that.
    Eigen::MatrixX3d samples;
    std::function<Eigen::VectorXd(const Eigen::VectorXd&)> sampled;
    std::function<std::unique_ptr<mapper::Mapping>(const mapper::MortarOptions&)> mortar;
};

/// What is mapped to what.
struct Pair {
    std::string name;
    std::vector<int> sizes, quickSizes;
    std::function<Setup(int n)> make;
    /// Also the dual basis.
    bool hasDual = false;
    bool onlyMortar = false;
    /// Orders of the error of the smooth field that theory gives, by operator.
    std::map<std::string, double> orders = {};
};

std::vector<Pair> pairs();

/// A row of the table for each operator.
void measure(const Pair& pair, int n, Table& table);

} // namespace tokay::benchmark
