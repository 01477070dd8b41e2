// Debian's Chromium, drawing without a graphics card.

import { chromium, type Browser } from "playwright-core";

const kFlags = [
  "--no-sandbox",
  "--use-gl=angle",
  "--use-angle=swiftshader",
  "--enable-unsafe-swiftshader",
  "--disable-quic",
  "--disable-background-networking",
  "--disable-component-update",
  "--disable-sync",
];

export function launchBrowser(): Promise<Browser> {
  const executablePath = process.env.BURNISH_CHROMIUM ?? "/usr/bin/chromium";
  return chromium.launch({ executablePath, args: kFlags });
}
