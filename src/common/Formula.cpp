// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/Formula.hpp"

#include "common/errors.hpp"

#include <fmt/format.h>
#include <muParser.h>

#include <cmath>

namespace tokay {

struct Formula::Implementation {
    std::string text;
    std::string where;
    double x = 0;
    double y = 0;
    double z = 0;
    double t = 0;
    mu::Parser parser;

    Implementation(const std::string& theText, const std::string& theWhere)
        : text(theText), where(theWhere) {
        parser.DefineVar("x", &x);
        parser.DefineVar("y", &y);
        parser.DefineVar("z", &z);
        parser.DefineVar("t", &t);
        parser.DefineConst("pi", M_PI);
        parser.DefineConst("e", M_E);
        parser.SetExpr(text);
    }

    InputError error(const mu::Parser::exception_type& exception) const {
        return InputError(fmt::format("{}formula '{}' cannot be read: {} Variables are x, y, z "
                                      "[m] and t [s].",
                                      where, text, exception.GetMsg()));
    }
};

Formula::Formula(const std::string& text, const std::string& where)
    : implementation_(std::make_unique<Implementation>(text, where)) {
    try {
        implementation_->parser.Eval();
    } catch (const mu::Parser::exception_type& exception) {
        throw implementation_->error(exception);
    }
}

Formula::Formula(const Formula& other)
    : Formula(other.implementation_->text, other.implementation_->where) {}

Formula& Formula::operator=(const Formula& other) {
    return *this = Formula(other);
}

Formula::Formula(Formula&&) noexcept = default;
Formula& Formula::operator=(Formula&&) noexcept = default;
Formula::~Formula() = default;

double Formula::operator()(const Eigen::Vector3d& at, double t) const {
    implementation_->x = at[0];
    implementation_->y = at[1];
    implementation_->z = at[2];
    implementation_->t = t;
    double value = 0;
    try {
        value = implementation_->parser.Eval();
    } catch (const mu::Parser::exception_type& exception) {
        throw implementation_->error(exception);
    }
    if (!std::isfinite(value)) {
        throw InputError(fmt::format("{}formula '{}' gives {} at x = {}, y = {}, z = {}, t = {}",
                                     implementation_->where, implementation_->text, value, at[0],
                                     at[1], at[2], t));
    }
    return value;
}

bool Formula::dependsOnTime() const {
    return implementation_->parser.GetUsedVar().count("t") > 0;
}

bool Formula::dependsOnPlace() const {
    const auto& used = implementation_->parser.GetUsedVar();
    return used.count("x") + used.count("y") + used.count("z") > 0;
}

const std::string& Formula::text() const {
    return implementation_->text;
}

} // namespace tokay
