#pragma once

#include <filesystem>

#include "mesh/triangle_mesh.h"
#include "transfer/diffuse_transfer.h"

namespace haarlight {

/// Writes the transfer, all or nothing (writeFileAtomically). docs/transfer.md has the format: a
/// header of 64 bytes, float32 values, CRC-32; all numbers little-endian. Throws InputError when
/// the file cannot be written.
void writeTransfer(const std::filesystem::path& path, const DiffuseTransfer& transfer);

/// Reads what writeTransfer writes, bit by bit. Throws InputError when the file is missing, none of
/// this kind, of a newer version, cut off or longer than its header says, changed, or when its
/// header holds what no transfer has. Takes no more memory than some multiple of the file's size.
DiffuseTransfer readTransfer(const std::filesystem::path& path);

/// Throws InputError, naming both, unless the transfer of file `path` was computed for this mesh:
/// the same positions and triangles. `meshName` is for the message.
void requireTransferOf(const DiffuseTransfer& transfer, const std::filesystem::path& path,
                       const TriangleMesh& mesh, const std::string& meshName);

}  // namespace haarlight
