#include "tests/support/formula.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace gnomon::testing {
namespace {

constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

/// Reads from left to right and computes as it goes.
class Reader {
public:
    Reader(const std::string& text, const std::map<std::string, double>& names)
        : rest_(text.c_str()), text_(text), names_(names) {}

    double formula() {
        do {
            const double value = sum();
            if (word("otherwise") || end()) return value;
            if (!word("if")) return fail("expected if or otherwise");
            if (condition()) return value;
        } while (sign(";"));
        return fail("no row holds");
    }

private:
    void skip() {
        while (*rest_ == ' ') ++rest_;
    }
    bool end() {
        skip();
        return *rest_ == 0;
    }
    bool sign(const std::string& s) {
        skip();
        if (std::string_view(rest_).substr(0, s.size()) != s) return false;
        rest_ += s.size();
        return true;
    }
    bool word(const std::string& w) {
        skip();
        const char after = std::string_view(rest_).size() > w.size() ? rest_[w.size()] : ' ';
        if (std::isalnum(static_cast<unsigned char>(after)) != 0 || after == '_') return false;
        return sign(w);
    }
    double fail(const char* why) {
        ADD_FAILURE() << why << " at \"" << rest_ << "\" of \"" << text_ << '"';
        return no_number;
    }

    double sum() {
        double value = operand();
        for (;;) {
            if (sign("+"))
                value += operand();
            else if (sign("-"))
                value -= operand();
            else
                return value;
        }
    }
    double operand() {
        skip();
        if (std::isdigit(static_cast<unsigned char>(*rest_)) != 0) {
            char* after = nullptr;
            const double value = std::strtod(rest_, &after);
            rest_ = after;
            return value;
        }
        for (const auto& [function, smaller] : {std::pair("min", true), std::pair("max", false)})
            if (word(function)) {
                if (!sign("(")) return fail("expected (");
                const double a = sum();
                if (!sign(",")) return fail("expected ,");
                const double b = sum();
                if (!sign(")")) return fail("expected )");
                return smaller ? std::min(a, b) : std::max(a, b);
            }
        const char* begin = rest_;
        while (std::isalnum(static_cast<unsigned char>(*rest_)) != 0 || *rest_ == '_' || *rest_ == '.' ||
               (rest_ > begin && rest_[-1] == '_' && (*rest_ == '-' || *rest_ == '+')))
            ++rest_;
        const auto found = names_.find(std::string(begin, rest_));
        if (found != names_.end()) return found->second;
        return fail("unknown name before");
    }
    bool comparison() {
        const double a = sum();
        if (sign("<")) return a < sum();
        if (sign("=")) return a == sum();
        return a != 0; // a name alone
    }
    /// Conjunctions bind closer than disjunctions; both sides are always read.
    bool condition() {
        bool any = false;
        do {
            bool all = true;
            do {
                const bool holds = comparison();
                all = all && holds;
            } while (word("and"));
            any = any || all;
        } while (word("or"));
        return any;
    }

    const char* rest_;
    const std::string& text_;
    const std::map<std::string, double>& names_;
};

} // namespace

double value_of_formula(const std::string& formula, const std::map<std::string, double>& names) {
    return Reader(formula, names).formula();
}

} // namespace gnomon::testing
