// Parts that appear one after the other, so that no turn of the page's thread is long.

import type { ComponentChildren } from "preact";
import { useEffect, useState } from "preact/hooks";

const kTurnMs = 10; // less than a picture of the screen

/** Shows one child at first, and one more each turn. */
export function Gradual({ children }: { children: ComponentChildren[] }) {
  const [shown, setShown] = useState(1);
  const isWhole = shown >= children.length;
  useEffect(() => {
    if (isWhole) return;
    const timer = setTimeout(() => setShown(shown + 1), kTurnMs);
    return () => clearTimeout(timer);
  }, [shown, isWhole]);
  return <>{children.slice(0, shown)}</>;
}
