#include "experiments/report/plot.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>
#include <array>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <csignal>
#include <filesystem>
#include <system_error>
#include <thread>

#include "io/errors.hpp"
#include "io/files.hpp"

namespace autoref::experiments {
namespace {

constexpr int kPlotWidth_px = 800;
constexpr int kIntervalRowHeight_px = 26;
constexpr int kIntervalFrameHeight_px = 90;

bool begins_letter(char c) { return (static_cast<unsigned char>(c) & 0xc0) != 0x80; }

bool is_control(char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; }

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds kPause{2};
constexpr std::size_t kLongestTrouble = 300;  // maximum number of characters
constexpr const char* kMessages = "messages.txt";

// Runs gnuplot in the temporary folder and redirects its output to a file there.
class SpawnActions {
 public:
  explicit SpawnActions(const io::WorkingFolder& workplace) {
    posix_spawn_file_actions_init(&actions_);
    posix_spawn_file_actions_addchdir_np(&actions_, workplace.path().c_str());
    // gnuplot must never wait for input.
    posix_spawn_file_actions_addopen(&actions_, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&actions_, STDOUT_FILENO, kMessages,
                                     O_WRONLY | O_CREAT | O_APPEND, 0600);
    posix_spawn_file_actions_adddup2(&actions_, STDOUT_FILENO, STDERR_FILENO);
  }
  ~SpawnActions() { posix_spawn_file_actions_destroy(&actions_); }
  SpawnActions(const SpawnActions&) = delete;
  SpawnActions& operator=(const SpawnActions&) = delete;

  const posix_spawn_file_actions_t* actions() const { return &actions_; }

 private:
  posix_spawn_file_actions_t actions_{};
};

// Returns 0 or the error number; ENOENT if gnuplot is not installed.
int start(const io::WorkingFolder& workplace, std::string script, pid_t& process) {
  const SpawnActions actions(workplace);
  std::string program = "gnuplot";
  std::string without_user_settings = "-d";
  const std::array<char*, 4> arguments = {program.data(), without_user_settings.data(),
                                          script.data(), nullptr};
  return posix_spawnp(&process, program.c_str(), actions.actions(), nullptr, arguments.data(),
                      environ);
}

// Waits for the process. Returns why it failed, or an empty string.
std::string end_of(pid_t process, double longest_s) {
  const auto deadline = Clock::now() + std::chrono::duration<double>(longest_s);
  int status = 0;
  pid_t ended = 0;
  while (ended == 0 && Clock::now() < deadline) {
    // Polls, because waitpid() has no timeout.
    ended = waitpid(process, &status, WNOHANG);
    if (ended == 0) std::this_thread::sleep_for(kPause);
  }
  if (ended == 0) {
    kill(process, SIGKILL);
    waitpid(process, &status, 0);
    return fmt::format("gnuplot took longer than {} s", longest_s);
  }
  if (ended == process && WIFEXITED(status) && WEXITSTATUS(status) == 0) return "";
  return "gnuplot failed";
}

std::string one_line(std::string text) {
  for (char& c : text) c = c == '\n' || c == '\r' || c == '\t' ? ' ' : c;
  const std::size_t begin = text.find_first_not_of(' ');
  return begin == std::string::npos ? "" : text.substr(begin, kLongestTrouble);
}

}  // namespace

std::string script_head(std::string_view name, int height_px) {
  return fmt::format(
      "# Draws {0}.svg from {0}.csv: gnuplot {0}.gp\n"
      "reset\n"
      "set encoding utf8\n"
      "set terminal svg noenhanced size {1},{2} font 'Helvetica,13' background 'white' name '{0}'\n"
      "set output '{0}.svg'\n"
      "set datafile separator ','\n"
      "set datafile columnheaders\n"
      "data = '{0}.csv'\n"
      "set border 3 lc rgb '#777777'\n"
      "set tics nomirror out\n"
      "set grid lc rgb '#e4e4e4' lt 1 lw 1\n",
      name, kPlotWidth_px, height_px);
}

double tic_step(double span) {
  // Multiplying by these factors in turn gives 2, 5 and 10 times the power of ten.
  double step = std::pow(10.0, std::floor(std::log10(span / 5)));
  for (const double factor : {2.0, 2.5, 2.0}) {
    if (span / step > 5) step *= factor;
  }
  return step;
}

std::string note_of_cut(std::size_t groups) {
  if (groups <= kMostGroupsInPlot) return "";
  return fmt::format(" Only the first {} of {} are drawn; the data file contains all.",
                     kMostGroupsInPlot, groups);
}

std::string script_text(std::string_view text) {
  std::string quoted = "'";
  for (const char c : text) {
    // In gnuplot's single quotes nothing is special except the quote itself, which is doubled.
    if (c == '\'') quoted += '\'';
    quoted += is_control(c) ? ' ' : c;
  }
  return quoted + "'";
}

std::string script_tics(std::string_view axis, const std::vector<std::string>& labels) {
  std::vector<std::string> tics;
  tics.reserve(labels.size());
  for (const std::string& label : labels) {
    tics.push_back(
        fmt::format("{} {}", script_text(shortened(label, kLongestLabel)), tics.size() + 1));
  }
  return fmt::format("set {}tics ({})\n", axis, fmt::join(tics, ", "));
}

std::string shortened(const std::string& text, std::size_t letters) {
  std::size_t count = 0;
  std::size_t cut = 0;  // end of the last character that fits before an ellipsis
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (!begins_letter(text[i])) continue;
    if (++count == letters) cut = i;
  }
  return count <= letters ? text : text.substr(0, cut) + "…";
}

std::string interval_rows_script(std::string_view name, const std::vector<std::string>& labels,
                                 std::string_view axis, std::string_view meaning) {
  const int rows = static_cast<int>(labels.size());
  return script_head(name, kIntervalFrameHeight_px + kIntervalRowHeight_px * rows) +
         script_tics("y", labels) +
         fmt::format(
             "set ylabel {0}\n"
             "set yrange [{1}.6:0.4]\n"
             "set xlabel {2}\n"
             "set xrange [*<0:0<*]\n"
             "set arrow from first 0, graph 0 to first 0, graph 1 nohead lc rgb '#777777' dt 2\n"
             "plot data using 'mean_diff':'row':'low95':'high95' with xerrorbars pt -1 lw 2 lc rgb "
             "'{3}' notitle, \\\n"
             "     data using 'mean_diff':'row' with points pt 7 ps 0.6 lc rgb '{3}' notitle\n",
             script_text(axis), rows, script_text(meaning), kBlue);
}

Drawing draw(const Plot& plot, double longest_s) {
  const io::WorkingFolder workplace;
  io::replace_file(workplace / (plot.name + ".csv"), plot.csv);
  io::replace_file(workplace / (plot.name + ".gp"), plot.script);
  pid_t process = 0;
  const int error_number = start(workplace, plot.name + ".gp", process);
  if (error_number != 0) {
    return {"", "gnuplot cannot be started: " + std::generic_category().message(error_number),
            error_number == ENOENT};
  }
  const std::string trouble = end_of(process, longest_s);
  const std::string svg = io::read_file(workplace / (plot.name + ".svg")).value_or("");
  // Exit code 0 does not guarantee a complete drawing, but this tag ends one.
  if (trouble.empty() && svg.find("</svg>") != std::string::npos) return {svg, "", false};
  const std::string messages = one_line(io::read_file(workplace / kMessages).value_or(""));
  return {"", fmt::format("{}: {}", trouble.empty() ? "gnuplot drew nothing" : trouble, messages),
          false};
}

}  // namespace autoref::experiments
