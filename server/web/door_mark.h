#pragma once

namespace burnish {

/// Metadata with which the web door marks its calls inside the process. gRPC knows neither the
/// address nor the certificate of the door's clients. The server believes both only beside the
/// secret, and no call of gRPC's own clients can have that.
inline constexpr char kDoorSecretKey[] = "burnish-door-secret";
inline constexpr char kDoorPeerKey[] = "burnish-door-peer";
inline constexpr char kDoorCertificateKey[] = "burnish-door-certificate-bin";  ///< a common name

}  // namespace burnish
