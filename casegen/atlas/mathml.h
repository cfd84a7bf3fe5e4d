// What tables say in text, as MathML: formulas and conditions.
#pragma once

#include "casegen/condition.h"

#include <set>
#include <string>
#include <string_view>

namespace gnomon::atlas {

/// A formula as people write it (Case::formula), as a <math> element:
///     formula    = row { ";" row }                  several rows stand behind one brace
///     row        = expression [ "if" condition | "otherwise" ]
///     condition  = comparison { ("and" | "or") comparison }
///     comparison = expression ("<" | "<=" | ">" | ">=" | "=" | "!=") expression, or a name alone
///     expression   of + - * / ^, ( ), | |, numbers, names, and functions: min(a, b)
/// Names become what the documents print: p.x is p with the index x, n_-y is n with the index -y, along_x is
/// d_on.r, side_y is d_c.g; names in capitals are values. Throws Error that shows the formula and names the
/// character or word that does not belong there.
std::string formula_to_mathml(std::string_view formula);

/// A disjunction of conjunctions over s_c, d_c.r, d_c.g, t_h, t_v, D_r, D_g, with the documents' numbers for
/// the sides (docs/revectorization.md, 1): a <math> element with a row per alternative.
std::string condition_to_mathml(const Conditions& conditions);

/// A name of the formulas as a MathML element, without <math>: for a legend.
std::string name_to_mathml(std::string_view name);

/// The names in a formula, functions and the grammar's words not among them. Throws as formula_to_mathml.
std::set<std::string> names_in(std::string_view formula);

} // namespace gnomon::atlas
