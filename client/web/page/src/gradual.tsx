// Parts that appear one after the other, so that no turn of the page's thread is long.

import type { ComponentChildren } from "preact";
import { useEffect, useState } from "preact/hooks";

const kTurnMs = 10; // less than a picture of the screen

/** Shows nothing at first, and one more child each turn: the first turn has the rest of the page. */
export function Gradual({ children }: { children: ComponentChildren[] }) {
  const [shown, setShown] = useState(0);
  const isWhole = shown >= children.length;
  useEffect(() => {
    if (isWhole) return;
    const timer = setTimeout(() => setShown(shown + 1), kTurnMs);
    return () => clearTimeout(timer);
  }, [shown, isWhole]);
  return <>{children.slice(0, shown)}</>;
}
