// How the surface is lit.

import { useRef } from "preact/hooks";
import { command } from "./commands";
import { useLink } from "./context";
import { Button, Choice, Title } from "./controls";
import type { PanelProps } from "./filter_panel";
import { Slider, linear } from "./slider";
import type { Light, Lighting } from "./snapshot";
import { fixed } from "./words";

export const kLights: (readonly [Light, string, string])[] = [
  ["clay", "Clay", "A lamp, the sky and a weak second lamp."],
  ["radiance", "Radiance scaling", "Brightens what bends outwards and darkens what bends inwards."],
  ["cavity", "Cavity", "Bright ridges and dark valleys."],
  ["raking", "Raking light", "One hard lamp. Low over the surface it shows the finest relief."],
  ["ceramic", "Ceramic", "White glaze with bright windows."],
  ["bronze", "Bronze", "Dark metal."],
  ["slopes", "Slopes", "Each direction of a slope has its own tone."],
  ["unlit", "Unlit", "The colours alone, without light."],
];
const kWithLamp: Light[] = ["clay", "radiance", "cavity", "raking"];
const kRadianceMax = 2;
const kCavityMax = 2.5;

export function LightPanel({ document }: PanelProps) {
  const link = useLink();
  const light = document.light;
  const hasLamp = kWithLamp.includes(light.kind);
  const strength = (name: string, high: number, value: number, line: (value: number) => string) => (
    <>
      <Title text={name} />
      <Slider
        name={name}
        value={value}
        scale={linear(0, high)}
        format={fixed(2)}
        onMove={(moved) => link.send(line(moved))}
        onDone={(moved) => link.send(line(moved))}
      />
    </>
  );
  return (
    <>
      <Choice
        name="Light"
        value={light.kind}
        hint={kLights.find(([kind]) => kind === light.kind)?.[2]}
        choices={kLights.map(([kind, label]) => [kind, label] as const)}
        onChange={(kind) => link.send(command.light(kind))}
      />
      {hasLamp && <Ball light={light} />}
      {light.kind === "radiance" &&
        strength("Scaling", kRadianceMax, light.radiance, command.radiance)}
      {light.kind === "cavity" &&
        strength("Ridges", kCavityMax, light.ridge, (to) => command.cavity(to, light.valley))}
      {light.kind === "cavity" &&
        strength("Valleys", kCavityMax, light.valley, (to) => command.cavity(light.ridge, to))}
      {hasLamp && strength("Highlight", 1, light.specular, command.specular)}
      {strength("Occlusion", 1, light.occlusion, command.occlusion)}
      <Button label="As at first" onClick={() => link.send(command.lightDefault())} />
    </>
  );
}

/** A drag on the ball moves the lamp: the middle is the eye, the rim the picture's plane. */
function Ball({ light }: { light: Lighting }) {
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
    const azimuth = (light.azimuth + turn[0] + 360) % 360;
    const elevation = Math.min(90, Math.max(0, light.elevation + turn[1]));
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
      aria-valuenow={Math.round(light.elevation)}
      aria-valuemin={0}
      aria-valuemax={90}
      aria-valuetext={`azimuth ${Math.round(light.azimuth)}°, elevation ${Math.round(light.elevation)}°`}
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
          cx={(ring / 12) * light.ballX}
          cy={(-ring / 12) * light.ballY}
          r={1 - ring / 12}
        />
      ))}
      <circle class="lamp" cx={light.ballX} cy={-light.ballY} r={0.13} />
    </svg>
  );
}
