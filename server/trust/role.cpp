#include "server/trust/role.h"

#include <utility>

namespace burnish {

// The only place that says which RPC needs which role. Health is for probes, which have no
// password. Reflection shows only what the repository also shows.
static constexpr std::pair<std::string_view, Role> kLeastRoles[] = {
    {"/grpc.health.v1.Health/Check", Role::kAnyone},
    {"/grpc.health.v1.Health/Watch", Role::kAnyone},
    {"/grpc.reflection.v1alpha.ServerReflection/ServerReflectionInfo", Role::kAnyone},

    {"/burnish.v1.Library/ListScans", Role::kViewer},
    {"/burnish.v1.Library/DescribeScan", Role::kViewer},
    {"/burnish.v1.Library/DescribePages", Role::kViewer},
    {"/burnish.v1.Library/FetchPages", Role::kViewer},
    {"/burnish.v1.Library/DescribeSheets", Role::kViewer},
    {"/burnish.v1.Library/FetchSheets", Role::kViewer},
    {"/burnish.v1.Library/ProposeEdges", Role::kViewer},
    {"/burnish.v1.Library/Import", Role::kEditor},
    {"/burnish.v1.Library/PrepareScan", Role::kEditor},
    {"/burnish.v1.Library/RenameScan", Role::kOwner},
    {"/burnish.v1.Library/SetScanUnit", Role::kEditor},
    {"/burnish.v1.Library/DeleteScan", Role::kOwner},

    {"/burnish.v1.Editing/ListSessions", Role::kViewer},
    {"/burnish.v1.Editing/GetState", Role::kViewer},
    {"/burnish.v1.Editing/GetHistory", Role::kViewer},
    {"/burnish.v1.Editing/GetPeople", Role::kViewer},
    {"/burnish.v1.Editing/GetCells", Role::kViewer},
    {"/burnish.v1.Editing/GetPageValues", Role::kViewer},
    {"/burnish.v1.Editing/Watch", Role::kViewer},
    {"/burnish.v1.Editing/Edit", Role::kViewer},  // as in any session, a viewer's edits are refused
    {"/burnish.v1.Editing/GetDeviation", Role::kViewer},
    {"/burnish.v1.Editing/GetSection", Role::kViewer},
    {"/burnish.v1.Editing/Export", Role::kViewer},
    {"/burnish.v1.Editing/OpenSession", Role::kEditor},
    // These four also need the session's own roles.
    {"/burnish.v1.Editing/CloseSession", Role::kEditor},
    {"/burnish.v1.Editing/RenameSession", Role::kEditor},
    {"/burnish.v1.Editing/DeleteSession", Role::kEditor},
    {"/burnish.v1.Editing/SetRole", Role::kEditor},
    {"/burnish.v1.Editing/Apply", Role::kEditor},
    {"/burnish.v1.Editing/UploadCellFields", Role::kEditor},
    {"/burnish.v1.Editing/ForkSession", Role::kEditor},
};

std::string_view role_name(Role role) {
  switch (role) {
    case Role::kViewer:
      return "viewer";
    case Role::kEditor:
      return "editor";
    case Role::kOwner:
      return "owner";
    case Role::kAnyone:
      break;
  }
  return "anyone";
}

Result<Role> parse_role(const std::string& text) {
  for (const Role role : {Role::kViewer, Role::kEditor, Role::kOwner})
    if (text == role_name(role)) return role;
  return invalid_argument("'" + text + "' is not one of viewer, editor, owner");
}

std::optional<Role> least_role(std::string_view method) {
  for (const auto& [known, role] : kLeastRoles)
    if (known == method) return role;
  return std::nullopt;
}

bool is_open_to_all(std::string_view method) {
  return least_role(method) == Role::kAnyone;
}

}  // namespace burnish
