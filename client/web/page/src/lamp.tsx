// A ball that shows the lamp.

import { useRef } from "preact/hooks";
import { command } from "./commands";
import { useLink } from "./context";
import type { LampWidget } from "./snapshot";

/** A drag on the ball moves the lamp: the middle is the eye, the rim the picture's plane. */
export function Lamp(lamp: LampWidget) {
  const link = useLink();
  const ball = useRef<SVGSVGElement>(null);
  const kStepDegrees = 5;
  const point = (event: PointerEvent) => {
    if (event.buttons === 0) return;
    const box = ball.current!.getBoundingClientRect();
    const x = (2 * (event.clientX - box.left)) / box.width - 1;
    const y = 1 - (2 * (event.clientY - box.top)) / box.height;
    link.send(command.lamp(x, y));
  };
  const key = (event: KeyboardEvent) => {
    const turns: Record<string, [number, number]> = {
      ArrowLeft: [kStepDegrees, 0],
      ArrowRight: [-kStepDegrees, 0],
      ArrowUp: [0, kStepDegrees],
      ArrowDown: [0, -kStepDegrees],
    };
    const turn = turns[event.key];
    if (!turn) return;
    event.preventDefault();
    event.stopPropagation();
    const azimuth = (lamp.azimuth + turn[0] + 360) % 360;
    const elevation = Math.min(90, Math.max(0, lamp.elevation + turn[1]));
    link.send(command.lightDirection(azimuth, elevation));
  };
  return (
    <svg
      ref={ball}
      class="ball"
      viewBox="-1 -1 2 2"
      role="slider"
      tabindex={0}
      aria-label="Lamp"
      aria-valuenow={Math.round(lamp.elevation)}
      aria-valuemin={0}
      aria-valuemax={90}
      aria-valuetext={`azimuth ${Math.round(lamp.azimuth)}°, elevation ${Math.round(lamp.elevation)}°`}
      onPointerDown={(event) => {
        ball.current!.setPointerCapture(event.pointerId);
        point(event);
      }}
      onPointerMove={point}
      onKeyDown={key}
    >
      <title>Drag the lamp. In the picture: Ctrl+Shift and a drag with the right button.</title>
      <circle class="globe" r={1} />
      {Array.from({ length: 12 }, (_, ring) => (
        <circle
          key={ring}
          class="shine"
          cx={(ring / 12) * lamp.ballX}
          cy={(-ring / 12) * lamp.ballY}
          r={1 - ring / 12}
        />
      ))}
      <circle class="lamp" cx={lamp.ballX} cy={-lamp.ballY} r={0.13} />
    </svg>
  );
}
