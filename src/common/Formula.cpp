// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/Formula.hpp"

#include "common/errors.hpp"

#include <fmt/format.h>
#include <muParser.h>

#include <cmath>
#include <cstring>

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
    }

    InputError error(const std::string& message) const {
        return InputError(fmt::format("{}formula '{}' {}", where, shortened(text), message));
    }

    InputError unreadable(const mu::Parser::exception_type& exception) const {
        return error(fmt::format("cannot be read: {}; variables are x, y, z [m] and t [s]",
                                 shortened(withoutFullStop(exception.GetMsg()))));
    }

    static std::string withoutFullStop(std::string message) {
        if (!message.empty() && message.back() == '.') {
            message.pop_back();
        }
        return message;
    }

    void parse() {
        if (text.size() > maxLength) {
            throw error(
                fmt::format("has {} characters; at most {} can be read", text.size(), maxLength));
        }
        if (assigns(text)) {
            throw error("assigns a value; write an expression (== compares)");
        }
        int nValues = 0;
        double value = 0;
        try {
            parser.SetExpr(text);
            value = *parser.Eval(nValues);
        } catch (const mu::Parser::exception_type& exception) {
            throw unreadable(exception);
        }
        if (nValues != 1) {
            throw error(fmt::format("has {} expressions; write one, with a point in decimal "
                                    "numbers (0.5, not 0,5)",
                                    nValues));
        }
        if (parser.GetUsedVar().empty() && !std::isfinite(value)) {
            throw error(fmt::format("is {}; it must be finite", value));
        }
    }

    // A single =, which is not part of ==, !=, <= or >=.
    static bool assigns(const std::string& text) {
        for (std::size_t i = 0; i < text.size(); ++i) {
            if (text[i] == '=' && i + 1 < text.size() && text[i + 1] == '=') {
                ++i;
            } else if (text[i] == '=' && (i == 0 || std::strchr("!<>", text[i - 1]) == nullptr)) {
                return true;
            }
        }
        return false;
    }

    static constexpr std::size_t maxLength = 4000; // muParser's limit is 5000
};

Formula::Formula(const std::string& text, const std::string& where)
    : implementation_(std::make_unique<Implementation>(text, where)) {
    implementation_->parse();
}

Formula::Formula() : Formula("0", "") {}

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
        throw implementation_->unreadable(exception);
    }
    if (!std::isfinite(value)) {
        throw implementation_->error(fmt::format("gives {} at x = {}, y = {}, z = {}, t = {}",
                                                 value, at[0], at[1], at[2], t));
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
