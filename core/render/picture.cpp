#include "core/render/picture.h"

#include "core/import/file_finder.h"
#include "core/import/image_saver.h"

namespace prizma {

std::string_view extensionOf(PictureFormat format) {
    return format == PictureFormat::Exr ? "exr" : "png";
}

Result<void> savePicture(const Picture& picture, PictureFormat format, const std::string& file) {
    switch (format) {
    case PictureFormat::Png8:
        return savePng(file, picture.width, picture.height, picture.display);
    case PictureFormat::Png16:
        return savePng16(file, picture.width, picture.height, picture.deep);
    case PictureFormat::Exr:
        break;
    }
    return saveExr(file, picture.width, picture.height, picture.radiance);
}

Result<void> savePicture(const Picture& picture, const std::string& file) {
    const PictureFormat png = picture.deep.empty() ? PictureFormat::Png8 : PictureFormat::Png16;
    return savePicture(picture, lowerExtension(file) == "exr" ? PictureFormat::Exr : png, file);
}

} // namespace prizma
