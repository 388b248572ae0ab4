#include <fmt/format.h>
#include <fmt/ranges.h>

#include "command_line.hpp"
#include "ndframe/run/summarize.hpp"
#include "shell_files.hpp"

namespace ndframe
{

namespace
{

/// Text as roff takes it: no escapes of its own, no line that begins with a request.
std::string roff(const std::string& text)
{
  std::string out;
  for (const char c : text) {
    if ((c == '.' || c == '\'') && (out.empty() || out.back() == '\n'))
      out += "\\&";
    out += c == '\\' ? "\\e" : (c == '-' ? "\\-" : std::string(1, c));
  }
  return out;
}

std::string optionText(const CLI::Option& option)
{
  std::string head;
  const auto add = [&](const std::string& name) {
    head += fmt::format("{}\\fB{}\\fR", head.empty() ? "" : ", ", roff(name));
  };
  for (const auto& name : option.get_snames())
    add("-" + name);
  for (const auto& name : option.get_lnames())
    add("--" + name);
  if (option.get_expected_max() > 0 && !option.get_type_name().empty())
    head += fmt::format(" \\fI{}\\fR", roff(option.get_type_name()));
  return fmt::format(".TP\n{}\n{}\n", head, roff(option.get_description()));
}

constexpr const char* description =
    "solves unilateral, frictionless contact between elastic bodies by a Neumann-Dirichlet domain decomposition and "
    "gives a guaranteed bound on the error of the answer. A scene is described in a deck, a Teuchos parameter list in "
    "XML; results are an Exodus file for ParaView, a summary in JSON and tables in CSV.";

constexpr const char* report =
    "writes one self-contained page with everything that a run or a study has written. NAME is the beginning of the "
    "files' names, or one of the files. Exit codes: 0 written, 2 a file or a Python package is missing.";

std::string newText()
{
  return fmt::format("writes a commented deck that runs, as a start: {}. from-geo takes a gmsh drawing or mesh, whose "
                     "physical groups are the bodies and sides. A file that exists already is replaced only with "
                     "--force. Exit codes: 0 written, 2 not.",
                     fmt::join(templateNames(), ", "));
}

constexpr const char* environment = R"(.TP
\fBOMP_NUM_THREADS\fR
Threads of a process. Without it: all processors for a process that runs alone, one for each of several.
.TP
\fBNO_COLOR\fR
Not empty: no line that is drawn again while the program works.
.TP
\fBNDFRAME_SHARE\fR
Folder share/ndframe of an installation, for programs elsewhere that write reports.
)";

} // namespace

std::string manualPage(const CLI::App& app)
{
  std::string options;
  for (const CLI::Option* option : app.get_options())
    if (!option->get_snames().empty() || !option->get_lnames().empty())
      options += optionText(*option);
  std::string exitCodes = exitCodeText();
  exitCodes = exitCodes.substr(exitCodes.find(": ") + 2);
  return fmt::format(
      ".TH NDFRAME 1 \"\" \"ndframe {}\" \"User Commands\"\n"
      ".SH NAME\nndframe \\- certified unilateral contact between elastic bodies\n"
      ".SH SYNOPSIS\n.B ndframe\n[\\fIOPTIONS\\fR] [\\fB\\-i\\fR] \\fIDECK\\fR\n.br\n"
      ".B ndframe new\n\\fITEMPLATE\\fR [\\fIFILE\\fR] [\\fB\\-\\-output\\fR \\fIDECK\\fR] [\\fB\\-\\-force\\fR]\n.br\n"
      ".B ndframe report\n\\fINAME\\fR [\\fB\\-\\-output\\fR \\fIFILE\\fR]\n"
      ".SH DESCRIPTION\n.B ndframe\n{}\n.PP\n.B ndframe new\n{}\n.PP\n.B ndframe report\n{}\n"
      ".SH OPTIONS\n{}.SH EXIT STATUS\n{}.SH ENVIRONMENT\n{}"
      ".SH SEE ALSO\nThe options \\fB\\-\\-help\\fR \\fIWORD\\fR and \\fB\\-\\-reference\\fR document the "
      "deck.\n",
      versionText(), roff(description), roff(newText()), roff(report), options, roff(exitCodes), environment);
}

} // namespace ndframe
