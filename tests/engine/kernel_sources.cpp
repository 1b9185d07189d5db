#include "kernel_sources.h"

#include <algorithm>
#include <array>
#include <regex>

namespace haarlight::test {

namespace {

using Matches = std::sregex_iterator;

std::string normalized(const std::string& parameter) {
  static const std::regex token(R"(\w+|\S)");
  static const std::array<std::string, 3> qualifiers{"__global", "restrict", "__restrict__"};
  std::string text;
  for (Matches match(parameter.begin(), parameter.end(), token), end; match != end; ++match)
    if (std::ranges::find(qualifiers, match->str()) == qualifiers.end())
      text += (text.empty() ? "" : " ") + match->str();
  return text;
}

std::vector<std::string> parametersOf(const std::string& list) {
  static const std::regex parameter("[^,]+");
  std::vector<std::string> parameters;
  for (Matches match(list.begin(), list.end(), parameter), end; match != end; ++match)
    parameters.push_back(normalized(match->str()));
  return parameters;
}

const KernelDeclaration* findByName(const std::vector<KernelDeclaration>& kernels,
                                    const std::string& name) {
  const auto found = std::ranges::find(kernels, name, &KernelDeclaration::name);
  return found == kernels.end() ? nullptr : &*found;
}

}  // namespace

std::string withoutComments(const std::string& source) {
  static const std::regex comment(R"(//[^\n]*|/\*[\s\S]*?\*/)");
  return std::regex_replace(source, comment, "");
}

std::vector<KernelDeclaration> kernelDeclarations(const std::string& source) {
  static const std::regex kernel(R"(HAARLIGHT_KERNEL\s+void\s+(\w+)\s*\(([^)]*)\))");
  const std::string text = withoutComments(source);
  std::vector<KernelDeclaration> kernels;
  for (Matches match(text.begin(), text.end(), kernel), end; match != end; ++match)
    kernels.push_back({(*match)[1], parametersOf((*match)[2])});
  return kernels;
}

std::string oneLaneSource(const std::string& source) {
  const std::string begin = "#if LANES_PER_ITEM == 1\n", other = "#else\n", end = "#endif\n";
  std::string result;
  std::size_t from = 0;
  for (std::size_t at; (at = source.find(begin, from)) != std::string::npos;) {
    const std::size_t otherAt = source.find(other, at), endAt = source.find(end, otherAt);
    if (endAt == std::string::npos) break;
    result += source.substr(from, otherAt - from).erase(at - from, begin.size());
    from = endAt + end.size();
  }
  return result + source.substr(from);
}

std::vector<std::string> helperNames(const std::string& source) {
  static const std::regex helper(R"(\binline\s+\w+\s+(\w+)\s*\()");
  const std::string text = withoutComments(source);
  std::vector<std::string> names;
  for (Matches match(text.begin(), text.end(), helper), end; match != end; ++match)
    names.push_back((*match)[1]);
  return names;
}

std::vector<std::string> twinDifferences(const std::vector<KernelDeclaration>& openCl,
                                         const std::vector<KernelDeclaration>& cuda) {
  std::vector<std::string> differences;
  for (const KernelDeclaration& kernel : openCl) {
    const KernelDeclaration* twin = findByName(cuda, kernel.name);
    if (!twin)
      differences.push_back(kernel.name + " has no CUDA twin");
    else if (twin->parameters != kernel.parameters)
      differences.push_back(kernel.name + " takes other parameters in CUDA");
  }
  for (const KernelDeclaration& kernel : cuda)
    if (!findByName(openCl, kernel.name))
      differences.push_back(kernel.name + " has no OpenCL twin");
  return differences;
}

std::vector<std::string> forbiddenWords(const std::string& source) {
  static const std::regex forbidden(
      R"(\bdouble\d*\b|\bhalf\w*|\b\d+\.\d*(e[+-]?\d+)?(?![\dfex])|\bimage\w*_t\b|\bsampler_t\b|)"
      R"(\btex[123]D\w*|\btexture\w*|\bsurf[123]D\w*|\bread_image\w*|)"
      R"(\b(intel_)?sub_group\w*|\bwork_group_\w*|)"
      R"(\b__\w*(shfl|ballot|activemask|match|reduce|syncwarp)\w*|\b__(all|any)\w*|)"
      R"(\batom\w*|\bcooperative_groups\b|\bprintf\b|\b(native|half)_\w*|\bmad\b|)"
      R"(\b\w*sqrt\w*|\b__f?div\w*|\bfdivide\w*|\b__frcp\w*|\bpowf?\b)");
  const std::string text = withoutComments(source);
  std::vector<std::string> words;
  for (Matches match(text.begin(), text.end(), forbidden), end; match != end; ++match)
    words.push_back(match->str());
  return words;
}

}  // namespace haarlight::test
