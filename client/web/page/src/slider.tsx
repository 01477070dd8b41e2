// A slider with its value as a number behind it, like client/app/widgets/value_slider.cpp.

import { useState } from "preact/hooks";
import { useLink } from "./context";
import { TypedField } from "./typed_field";

/** Maps a value to a place from 0 to 1 and back. */
export interface Scale {
  low: number;
  high: number;
  toPlace(value: number): number;
  toValue(place: number): number;
}

export const linear = (low: number, high: number): Scale => ({
  low,
  high,
  toPlace: (value) => (value - low) / (high - low),
  toValue: (place) => low + (high - low) * place,
});

/** Needs: 0 < low < high. */
export const logarithmic = (low: number, high: number): Scale => ({
  low,
  high,
  toPlace: (value) => Math.log(value / low) / Math.log(high / low),
  toValue: (place) => low * Math.pow(high / low, place),
});

const kBetaMax = 10;

/** The left half holds what smooths. */
export const betaScale: Scale = {
  low: 0,
  high: kBetaMax,
  toPlace: (beta) => (beta <= 1 ? beta / 2 : 0.5 + 0.5 * Math.sqrt((beta - 1) / (kBetaMax - 1))),
  toValue: (place) => {
    const right = 2 * place - 1;
    const value = right < 0 ? 2 * place : 1 + (kBetaMax - 1) * right * right;
    return Math.round(value * 100) / 100;
  },
};

const kSteps = 1000;

export interface SliderProps {
  /** Names the slider; its field is "NAME as a number". */
  name: string;
  value: number;
  scale: Scale;
  format: (value: number) => string;
  /** Called while the user moves the slider. */
  onMove?: (value: number) => void;
  onDone: (value: number) => void;
  disabled?: boolean;
  /** One of the classes that colour the grip. */
  tone?: string;
}

export function Slider({ name, value, scale, format, onMove, onDone, disabled, tone }: SliderProps) {
  const [dragged, setDragged] = useState<number | null>(null);
  const shown = dragged ?? value;
  const place = Math.round(kSteps * Math.min(1, Math.max(0, scale.toPlace(shown))));
  const at = (event: Event) => {
    const moved = Number((event.target as HTMLInputElement).value);
    return moved === place ? shown : scale.toValue(moved / kSteps);
  };
  return (
    <div class="slider">
      <input
        type="range"
        class={tone}
        aria-label={name}
        aria-valuetext={format(shown)}
        min={0}
        max={kSteps}
        value={place}
        disabled={disabled}
        onInput={(event) => {
          setDragged(at(event));
          onMove?.(at(event));
        }}
        onChange={(event) => {
          onDone(at(event));
          setDragged(null);
        }}
      />
      <NumberField {...{ name, scale, format, onDone, disabled }} value={shown} />
    </div>
  );
}

/** Takes a typed number. A number beyond the limits becomes the limit, with a message. */
function NumberField({ name, value, scale, format, onDone, disabled }: Omit<SliderProps, "onMove">) {
  const link = useLink();
  const take = (text: string) => {
    const read = Number(text.replace(",", "."));
    if (text.trim() === "" || !Number.isFinite(read))
      return link.refuse(`${name}: '${text}' is not a number`);
    const taken = Math.min(scale.high, Math.max(scale.low, read));
    if (taken !== read)
      link.refuse(
        `${name}: ${read} is outside ${format(scale.low)} to ${format(scale.high)}; ${format(taken)} is taken`,
      );
    onDone(taken);
  };
  return (
    <TypedField
      class="number"
      inputMode="decimal"
      name={`${name} as a number`}
      shown={format(value)}
      disabled={disabled}
      onTake={take}
    />
  );
}

/** Returns the class of a grip for a gradient scale: blue smooths, red sharpens. */
export const betaTone = (beta: number) => (beta < 1 ? "smooths" : beta > 1 ? "sharpens" : "keeps");
