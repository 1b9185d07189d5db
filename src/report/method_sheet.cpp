#include "report/method_sheet.h"

#include <fmt/format.h>

#include "image/contact_sheet.h"
#include "image/tonemap.h"

namespace haarlight {

namespace {

std::string label(const MethodPicture& picture) {
  return picture.note.empty() ? picture.method : picture.method + ", " + picture.note;
}

std::vector<LabelledImage> rowOfPictures(std::span<const MethodPicture> pictures,
                                         const std::vector<Image>& exposed) {
  std::vector<LabelledImage> labelled;
  for (std::size_t i = 0; i < pictures.size(); ++i)
    labelled.push_back({label(pictures[i]), exposed[i]});
  return labelled;
}

std::vector<Image> differencesFrom(const Image& reference, const std::vector<Image>& exposed) {
  std::vector<Image> differences;
  for (const Image& picture : exposed)
    differences.push_back(differenceImage(picture, reference, shownErrorScale));
  return differences;
}

std::vector<LabelledImage> rowOfErrors(std::span<const MethodPicture> pictures,
                                       const std::vector<Image>& differences, const ErrorRow& row) {
  std::vector<LabelledImage> labelled;
  for (std::size_t i = 0; i < pictures.size(); ++i)
    labelled.push_back(
        {i == row.reference
             ? fmt::format("error x {} against {}", shownErrorScale, pictures[i].method)
             : fmt::format("RMSE {:.2f} % of the mean", 100 * row.errors[i].relativeRootMeanSquare),
         differences[i]});
  return labelled;
}

}  // namespace

ErrorRow errorsAgainst(std::span<const MethodPicture> pictures, std::size_t reference,
                       std::span<const std::uint8_t> mask) {
  ErrorRow row{reference, {}};
  for (const MethodPicture& picture : pictures)
    row.errors.push_back(compareImages(picture.radiance, pictures[reference].radiance, mask));
  return row;
}

Image methodSheet(std::span<const MethodPicture> pictures, std::span<const ErrorRow> rows,
                  float stops) {
  std::vector<Image> exposed;
  for (const MethodPicture& picture : pictures) exposed.push_back(tonemap(picture.radiance, stops));
  std::vector<std::vector<Image>> differences;
  for (const ErrorRow& row : rows)
    differences.push_back(differencesFrom(exposed[row.reference], exposed));
  std::vector<std::vector<LabelledImage>> grid{rowOfPictures(pictures, exposed)};
  for (std::size_t i = 0; i < rows.size(); ++i)
    grid.push_back(rowOfErrors(pictures, differences[i], rows[i]));
  return contactGrid(grid);
}

}  // namespace haarlight
