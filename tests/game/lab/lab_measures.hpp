// Quantities measured in the scenes of scenarios/lab. Each function throws std::out_of_range or
// std::runtime_error if the scene does not show what it measures.
#pragma once

#include "game/lab/lab.hpp"

namespace autoref::game::lab_measures {

double slide_m(const LabRecord& record);
double switch_mps(const LabRecord& record);
double roll_m(const LabRecord& record);
double chip_m(const LabRecord& record);
double first_xy(const LabRecord& record);
double later_xy(const LabRecord& record);
double hop_z(const LabRecord& record);
double rebound_x(const LabRecord& record);
double rebound_net(const LabRecord& record);
double rebound_y(const LabRecord& record);
double rebound_flying(const LabRecord& record);
double behind_line_mm(const LabRecord& record);
double to_three_s(const LabRecord& record);
double top_mps(const LabRecord& record);
double stop_s(const LabRecord& record);
double stop_m(const LabRecord& record);
double turning_radps2(const LabRecord& record);
double turning_radps(const LabRecord& record);
double delay_ms(const LabRecord& record);
double pair_mps2(const LabRecord& record);
double robots_rebound(const LabRecord& record);
double middle_mm(const LabRecord& record);
double most_off_in_slow_turn_mm(const LabRecord& record);
double loses_at_radps(const LabRecord& record);
double off_in_slow_pull_mm(const LabRecord& record);
double most_pull_mps2(const LabRecord& record);
double is_lost_in_hard_pull(const LabRecord& record);
double most_off_when_held_mm(const LabRecord& record);
double most_faster_when_held_mps(const LabRecord& record);
double kicked_mps(const LabRecord& record);
double kick_on_the_run_deg(const LabRecord& record);
double fast_path_m(const LabRecord& record);
double slow_path_m(const LabRecord& record);
double arrival_mps(const LabRecord& record);
double received_off_mm(const LabRecord& record);

}  // namespace autoref::game::lab_measures
