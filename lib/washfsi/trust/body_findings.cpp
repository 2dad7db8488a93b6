// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/trust/body_findings.hpp"

#include "washfsi/support/errors.hpp"
#include "washfsi/support/format_text.hpp"
#include "washfsi/support/text.hpp"
#include "washfsi/trust/unseen_parts.hpp"

namespace washfsi {

namespace {

template <int Dim>
std::string place_text(const Point<Dim>& place) {
  std::string text;
  for (int d = 0; d < Dim; ++d) text += (d == 0 ? "" : ",") + format_text("%.3g", place[d]);
  return "(" + text + ")";
}

template <int Dim>
std::string survey_text(const BodySurvey<Dim>& body) {
  return format_text("%.0f cells, %.3g %s, from ", body.cells, body.volume, Dim == 2 ? "m2" : "m3") +
         place_text<Dim>(body.lower) + " to " + place_text<Dim>(body.upper) +
         format_text(" m, top speed %.3g m/s", body.top_speed);
}

// Without water a body is there for cloths to touch, however thin it is.
template <int Dim>
Finding presence_for_cloths(const Body<Dim>& body, const BodySurvey<Dim>& survey, double beside) {
  const std::string name = "body " + body.name;
  if (survey.cells == 0 && survey.nearest > beside)
    return {name,
            format_text("outside the box; the nearest cell's middle is %.3g m off", survey.nearest),
            Verdict::warn,
            0,
            Finding::none,
            "no cloth comes near it unless it leaves the box (-" + body.name + "_center, -" + body.name + "_scale)"};
  return {name,          survey.cells == 0 ? "thinner than a cell" : survey_text<Dim>(survey),
          Verdict::ok,   survey.cells,
          Finding::none, ""};
}

// `markers` are those of the body's walls in direct forcing.
template <int Dim>
Finding presence(const Body<Dim>& body, const BodySurvey<Dim>& survey, double all_cells, std::size_t markers) {
  const std::string name = "body " + body.name;
  if (survey.cells == 0 && markers > 0)
    return {name, format_text("a sheet of %zu markers", markers), Verdict::ok, 0, Finding::none, ""};
  if (survey.cells == 0)
    return {name,
            format_text("no cell's middle is in it; the nearest is %.3g m off", survey.nearest),
            Verdict::fail,
            0,
            Finding::none,
            "it holds no water: it is outside the box, thinner than a cell, or its STL file in another unit "
            "(-" +
                body.name + "_center, -" + body.name + "_scale)"};
  if (survey.cells == all_cells)
    return {name,
            format_text("it fills the box, all %.0f cells", all_cells),
            Verdict::fail,
            survey.cells,
            Finding::none,
            "no water is left: a drum is -" + body.name + "_inverted; an STL file in millimetres needs -" + body.name +
                "_scale 0.001"};
  return {name, survey_text<Dim>(survey), Verdict::ok, survey.cells, Finding::none, ""};
}

// Markers enforce no slip on a sheet as well as on a wall, but it acts as if it were 1.3 cells thick.
template <int Dim>
Finding thickness(const std::string& name, const BodySurvey<Dim>& survey, bool has_markers) {
  const bool is_thick = survey.thickness >= BodySurvey<Dim>::most_cells;
  const std::string text = format_text(is_thick ? "more than %.2g" : "%.2g in its thinnest tenth", survey.thickness);
  if (has_markers)
    return at_least(name + " cells across", survey.thickness, {1.4}, text,
                    "its thin parts act as if they were so thick; more -grid_cells");
  return at_least(name + " cells across", survey.thickness, {4, 1}, text,
                  "its load depends on where its walls lie in their cells; more -grid_cells");
}

// The jets from narrower blades have two or three cells, which carry them as these happen to lie.
template <int Dim>
Finding width(const std::string& name, const BodySurvey<Dim>& survey) {
  return at_least(name + " sheet width", survey.sheet_width, {6},
                  format_text("%.2g cells from edge to edge", survey.sheet_width),
                  "what fast water does to its thin parts depends on where they lie in their cells, by a quarter on "
                  "four; more -grid_cells");
}

// A drum without its wall is another machine; of other parts there may be more than are needed.
template <int Dim>
void add_unseen_parts(const Grid<Dim>& grid, const Body<Dim>& body, double time, Findings& findings) {
  const std::string box = list_text<Dim>(grid.lower()) + " to -grid_upper " + list_text<Dim>(grid.upper());
  for (const UnseenPart& part : unseen_parts(grid, body, time)) {
    if (part.is_inverted)
      throw InputError("-" + part.name + "_inverted true: the wall of " + part.name + " lies wholly outside the box, " +
                       format_text("%.3g m off at least; it must reach into -grid_lower ", part.nearest) + box);
    if (part.name != body.name)
      findings.push_back({"part " + part.name, format_text("outside the box, %.3g m off at least", part.nearest),
                          Verdict::fail, part.nearest, Finding::none,
                          "it holds nothing; it must reach into the box, or not be one of -..._parts"});
  }
}

// The overlaps of a body with those before it.
template <int Dim>
void add_overlaps(const Model<Dim>& model, std::size_t b, const std::vector<BodySurvey<Dim>>& surveys,
                  Findings& findings) {
  const BodySurvey<Dim>& survey = surveys[b];
  const std::string& name = model.body_list[b].name;
  for (std::size_t c = 0; c < b; ++c) {
    if (survey.shared[c] == 0) continue;
    const std::string& other = model.body_list[c].name;
    const bool within = survey.shared[c] == survey.cells || survey.shared[c] == surveys[c].cells;
    const std::string inner = survey.shared[c] == survey.cells ? name : other, outer = inner == name ? other : name;
    findings.push_back(
        {"bodies " + other + ", " + name,
         within ? inner + " lies wholly within " + outer : format_text("they share %.0f cells", survey.shared[c]),
         within ? Verdict::fail : Verdict::warn, survey.shared[c], Finding::none,
         "where bodies overlap, the first named holds the water and takes the load"});
  }
}

template <int Dim>
void add_body(const Model<Dim>& model, std::size_t b, const std::vector<BodySurvey<Dim>>& surveys, Findings& findings) {
  const BodySurvey<Dim>& survey = surveys[b];
  const std::string& name = model.body_list[b].name;
  if (!model.has_fluid) {
    findings.push_back(presence_for_cloths<Dim>(model.body_list[b], survey, model.grid.spacing().norm()));
    return;
  }
  const std::size_t markers =
      model.bodies.wall_forces() ? model.bodies.wall_forces()->markers().layout().of_body(b).markers.size() : 0;
  findings.push_back(presence<Dim>(model.body_list[b], survey, model.grid.cell_count(), markers));
  if (findings.back().verdict != Verdict::ok) return;
  findings.push_back(thickness(name, survey, markers > 0));
  if (model.bodies.wall_law() && !model.body_list[b].motion.at_rest()) findings.push_back(width(name, survey));
  add_overlaps(model, b, surveys, findings);
}

template <int Dim>
void add_motion(const Body<Dim>& body, const BodySurvey<Dim>& survey, Findings& findings) {
  const std::string advice = body.motion.table ? "are the angles of -" + body.name + "_motion_file in degrees? Say -" +
                                                     body.name + "_angle_unit deg"
                                               : "no machine is as fast; -" + body.name + "_angular_speed is in rad/s";
  const double fastest = body.motion.table ? 10 : 50;  // [m/s]: 1800 rpm at 0.26 m are 50; tables are of agitators
  if (survey.top_speed > fastest)
    findings.push_back(
        at_most(body.name + " speed", survey.top_speed, {fastest}, format_text("%.3g m/s", survey.top_speed), advice));
}

}  // namespace

template <int Dim>
Findings body_findings(const Model<Dim>& model, const std::vector<BodySurvey<Dim>>& surveys, double time) {
  Findings findings;
  for (std::size_t b = 0; b < surveys.size(); ++b) {
    add_unseen_parts<Dim>(model.grid, model.body_list[b], time, findings);
    add_body<Dim>(model, b, surveys, findings);
    add_motion<Dim>(model.body_list[b], surveys[b], findings);
  }
  return findings;
}

template Findings body_findings<2>(const Model<2>&, const std::vector<BodySurvey<2>>&, double);
template Findings body_findings<3>(const Model<3>&, const std::vector<BodySurvey<3>>&, double);

}  // namespace washfsi
