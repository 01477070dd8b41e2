// Messages to the user: toasts over the picture, and a list of all.

import { useState } from "preact/hooks";
import { useLink } from "./context";
import { Dialog } from "./dialog";
import { Button } from "./controls";
import type { Activity, Message } from "./snapshot";
import { timeOf } from "./words";

const kToastsMax = 4;

export function Toasts({ messages, activities }: { messages: Message[]; activities: Activity[] }) {
  const link = useLink();
  const [left, setLeft] = useState<ReadonlySet<number>>(new Set());
  return (
    <div class="toasts">
      {activities.map((one) => (
        <Progress key={one.number} activity={one} />
      ))}
      <div role="log" aria-label="Messages" aria-live="polite">
        {messages.filter((one) => !left.has(one.number)).slice(-kToastsMax).map((one) => (
          <div
            key={one.number}
            class={"toast " + one.severity}
            onAnimationEnd={() => setLeft((before) => new Set(before).add(one.number))}
          >
            <span>{one.text}</span>
            <Button label="×" name={`Dismiss: ${one.text}`} onClick={() => link.dismiss(one.number)} />
          </div>
        ))}
      </div>
    </div>
  );
}

function timeLeft(seconds: number): string {
  if (seconds < 0) return "";
  return seconds < 90 ? `${Math.ceil(seconds)} s left` : `${Math.ceil(seconds / 60)} min left`;
}

/** Long work with its progress and a way to end it. */
export function Progress({ activity }: { activity: Activity }) {
  const link = useLink();
  return (
    <div class="toast activity">
      <div>
        <div>{activity.title}</div>
        <progress aria-label={activity.title} max={1} value={activity.fraction} />
        <div class="faint">{[activity.phase, timeLeft(activity.secondsLeft)].filter(Boolean).join(", ")}</div>
      </div>
      <Button
        label="Cancel"
        name={`Cancel ${activity.title}`}
        onClick={() => link.send(`activity cancel ${activity.number}`)}
      />
    </div>
  );
}

export function MessageLog({ messages, onClose }: { messages: Message[]; onClose: () => void }) {
  return (
    <Dialog title="Messages" onClose={onClose}>
      <ul class="log">
        {messages.map((one) => (
          <li key={one.number} class={one.severity}>
            <span class="faint">{timeOf(one.time)}</span> {one.text}
          </li>
        ))}
        {messages.length === 0 && <li class="faint">no messages</li>}
      </ul>
      <Button label="Close" onClick={onClose} />
    </Dialog>
  );
}
