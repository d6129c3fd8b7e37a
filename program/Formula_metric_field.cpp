// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Formula_metric_field.h"

#include <muParser.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <functional>
#include <thread>
#include <utility>
#include <vector>

namespace program {

namespace {

double power(double x, double e) { return std::pow(x, e); }

// `position` counts the characters before; people count from 1.
[[noreturn]] void refuse(const Formula& formula, const std::string& what, std::size_t position)
{
  throw Formula_error(formula.option + " \"" + formula.text + "\": " + what + " at position "
                      + std::to_string((std::min)(position, formula.text.size()) + 1));
}

// the message of muParser without its own count of characters
std::string complaint_of(const mu::Parser::exception_type& e)
{
  std::string what = e.GetMsg();
  for(const char* words : {" found at position", " at expression position", " at position"})
    what = what.substr(0, what.find(words));
  while(!what.empty() && (what.back() == '.' || what.back() == '!'))
    what.pop_back();
  return what;
}

// muParser would take `x = 1` for an assignment.
void refuse_assignments(const Formula& formula)
{
  const std::string& s = formula.text;
  for(std::size_t i = s.find('='); i != std::string::npos; i = s.find('=', i + 1)) {
    const bool ends_a_comparison = i > 0 && std::string("=<>!").find(s[i-1]) != std::string::npos;
    const bool starts_one = i + 1 < s.size() && s[i+1] == '=';
    if(!ends_a_comparison && !starts_one)
      refuse(formula, "Unexpected assignment \"=\"", i);
  }
}

mu::Parser parser_of(const Formula& formula, double& x, double& y)
{
  refuse_assignments(formula);
  mu::Parser parser;
  try {
    parser.DefineVar("x", &x);
    parser.DefineVar("y", &y);
    parser.DefineConst("pi", std::acos(-1.));
    parser.DefineFun("pow", power);
    parser.SetExpr(formula.text);
    parser.Eval(); // compiles it
  }
  catch(const mu::Parser::exception_type& e) {
    refuse(formula, complaint_of(e), static_cast<std::size_t>((std::max)(e.GetPos(), 0)));
  }
  if(parser.GetNumResults() != 1)
    refuse(formula, "Unexpected list of several formulas", formula.text.find(','));
  return parser;
}

} // namespace

// The compiled formulas together with the variables they refer to.
class Formula_metric_field::Parsers
{
public:
  explicit Parsers(const std::vector<Formula>& formulas)
  {
    for(const Formula& formula : formulas)
      m_parsers.push_back(parser_of(formula, m_x, m_y));
  }

  Parsers(const Parsers&) = delete;
  Parsers& operator=(const Parsers&) = delete;

  Values operator()(const Point_2& p)
  {
    m_x = p.x();
    m_y = p.y();
    Values values = {};
    for(std::size_t i = 0; i < m_parsers.size(); ++i)
      values[i] = m_parsers[i].Eval();
    return values;
  }

private:
  double                  m_x = 0, m_y = 0;
  std::vector<mu::Parser> m_parsers;
};

// muParser evaluates on a stack of the parser, so every evaluation needs one
// for itself: threads start to look for it at different slots, and make a new
// one in the unlikely case that all are taken.
class Formula_metric_field::Pool_of_parsers
{
public:
  explicit Pool_of_parsers(std::vector<Formula> formulas)
    : m_formulas(std::move(formulas))
  {
    m_slots[0].parsers = std::make_unique<Parsers>(m_formulas); // so that errors show at once
  }

  Values operator()(const Point_2& p)
  {
    const std::size_t start = std::hash<std::thread::id>()(std::this_thread::get_id());
    for(std::size_t i = 0; i < m_slots.size(); ++i) {
      Slot& slot = m_slots[(start + i) % m_slots.size()];
      if(!slot.taken.test_and_set(std::memory_order_acquire))
        return evaluated_in(slot, p);
    }
    return Parsers(m_formulas)(p);
  }

private:
  struct alignas(64) Slot
  {
    std::atomic_flag         taken = ATOMIC_FLAG_INIT;
    std::unique_ptr<Parsers> parsers;
  };

  Values evaluated_in(Slot& slot, const Point_2& p)
  {
    struct Give_back
    {
      Slot& slot;
      ~Give_back() { slot.taken.clear(std::memory_order_release); }
    } give_back{slot};
    if(!slot.parsers)
      slot.parsers = std::make_unique<Parsers>(m_formulas);
    return (*slot.parsers)(p);
  }

  std::vector<Formula> m_formulas;
  std::array<Slot, 61> m_slots; // a prime, as ids of threads are multiples of the page size
};

Formula_metric_field::Formula_metric_field(const std::vector<Formula>& formulas, Construct_tensor tensor)
  : m_pool(std::make_shared<Pool_of_parsers>(formulas)), m_tensor(tensor)
{}

Formula_metric_field Formula_metric_field::from_sizes(const Formula& h1, const Formula& h2,
                                                      const Formula& theta)
{
  return Formula_metric_field({h1, h2, theta}, [](const Values& v)
                              { return Metric_tensor_2::from_sizes(v[0], v[1], v[2]); });
}

Formula_metric_field Formula_metric_field::from_entries(const Formula& m11, const Formula& m12,
                                                        const Formula& m22)
{
  return Formula_metric_field({m11, m12, m22}, [](const Values& v)
                              { return Metric_tensor_2::from_entries(v[0], v[1], v[2]); });
}

Formula_metric_field Formula_metric_field::from_size(const Formula& h)
{
  return Formula_metric_field({h}, [](const Values& v) { return Metric_tensor_2::from_size(v[0]); });
}

Metric_tensor_2 Formula_metric_field::operator()(const Point_2& p) const
{
  return m_tensor((*m_pool)(p));
}

} // namespace program
