// A file of a scene, positions in it, and the errors and warnings about all files of a scene.
#pragma once
#include <cstddef>
#include <deque>
#include <filesystem>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "host/formats/loading/diagnostic_log.h"

namespace candela::mitsuba {

/// A file in XML: that of the scene, or one that it includes.
class Document {
 public:
  /// `text` must outlive the document. `name` begins messages, and `folder` is the base of relative paths.
  Document(std::string name, std::filesystem::path folder, std::string_view text)
      : log(std::move(name)), folder_(std::move(folder)), text_(text) {}

  const std::filesystem::path& folder() const { return folder_; }
  std::string_view text() const { return text_; }
  scene::DiagnosticLog log;

 private:
  std::filesystem::path folder_;
  std::string_view text_;
};

/// The offset of an element in a document, at most the size of its text.
struct Place {
  Document* document = nullptr;
  std::size_t offset = 0;
};

/// Ends the reading of an object. SceneAssembly catches it, and continues with the next object.
struct PlacedError {
  Place place;
  std::string message;
};

/// The errors and warnings of a scene with all of its files.
class Report {
 public:
  explicit Report(bool lenient) : isLenient_(lenient) {}

  bool isLenient() const { return isLenient_; }
  Document& addDocument(std::string name, std::filesystem::path folder, std::string_view text);
  /// Returns a log for a file that is not in XML.
  scene::DiagnosticLog& addLog(const std::string& file) { return logs_.emplace_back(file); }

  void error(const Place& place, const std::string& message);
  /// Adds the errors of a file that is not in XML.
  void add(const scene::SceneError& error) {
    others_.insert(others_.end(), error.diagnostics.begin(), error.diagnostics.end());
  }
  /// Stores the first warning of each kind, and counts the others.
  void warn(const std::string& kind, const Place& place, const std::string& message);
  /// Adds an error whose message ends with what `--lenient` does instead ("renders it as ..."), or with it a warning.
  void deviate(const Place& place, const std::string& message, const std::string& lenient);
  /// Notes what is not rendered, which one warning names.
  void omit(const std::string& what) { omissions_.insert(what); }
  /// Notes what no picture of a path tracer shows.
  void ignore(const std::string& what) { ignored_.insert(what); }

  const std::set<std::string>& omissions() const { return omissions_; }
  const std::set<std::string>& ignored() const { return ignored_; }
  /// Returns whether so many errors were found that reading ends.
  bool isFull() const;
  /// Throws SceneError with all errors, file by file, if there are any.
  void throwIfErrors() const;
  std::vector<scene::Diagnostic> warnings() const;

 private:
  bool isLenient_;
  std::deque<Document> documents_{};
  std::deque<scene::DiagnosticLog> logs_{};
  std::vector<scene::Diagnostic> others_{};
  std::set<std::string> omissions_{}, ignored_{};
};

}  // namespace candela::mitsuba
