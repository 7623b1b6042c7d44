#include "app/line_output.hpp"

#include <sys/stat.h>

#include "app/output_file.hpp"

namespace autoref::app {

LineOutput::LineOutput(const char* flag, const std::string& path) : path_(path) {
  open_output(file_, flag, path);
  struct stat status {};
  is_regular_ = file_ && fstat(file_->descriptor(), &status) == 0 && S_ISREG(status.st_mode);
}

void LineOutput::add(std::string_view line) {
  waiting_.append(line).append(1, '\n');
  if (!is_regular_ || waiting_.size() <= kMostWaiting_bytes) return;
  io::write_all(file_->descriptor(), waiting_, path_);
  waiting_.clear();
}

void LineOutput::commit() {
  if (file_) file_->commit(waiting_);
}

}  // namespace autoref::app
