#pragma once

#include <string>

#include <grpcpp/grpcpp.h>

#include "burnish/v1/library.grpc.pb.h"
#include "client/connection/connection.h"

namespace burnish {

/// Connection::fetch_sheets() over any stub. The context belongs to the caller, who may cancel it.
Status fetch_sheet_parts(const std::string& server, v1::Library::Stub& library,
                         grpc::ClientContext& context, const SheetsWish& wish,
                         const Connection::SheetTaker& take);

}  // namespace burnish
