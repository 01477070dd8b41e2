// Debian's Chromium, drawing without a graphics card unless BURNISH_ANGLE names another way: gl-egl, vulkan.

import { chromium, type Browser } from "playwright-core";

const kAngle = process.env.BURNISH_ANGLE ?? "swiftshader";
const kFlags = [
  "--no-sandbox",
  "--use-gl=angle",
  `--use-angle=${kAngle}`,
  kAngle === "swiftshader" ? "--enable-unsafe-swiftshader" : "--ignore-gpu-blocklist",
  "--disable-quic",
  "--disable-background-networking",
  "--disable-component-update",
  "--disable-sync",
];

export function launchBrowser(): Promise<Browser> {
  const executablePath = process.env.BURNISH_CHROMIUM ?? "/usr/bin/chromium";
  return chromium.launch({ executablePath, args: kFlags });
}
