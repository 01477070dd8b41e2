// Small pictures of three strengths of the preset in force, to choose by eye.

import { useEffect } from "preact/hooks";
import { command } from "./commands";
import { useLink } from "./context";
import { Button } from "./controls";
import type { PresetInForce, StrengthPicture, Strengths } from "./snapshot";
import { fixed } from "./words";

const kSame = 1e-5; // values are rounded on their way
const kHint =
  "Shows a weaker and a stronger filter for a moment, to everybody in the session, and keeps small pictures of what you look at, to choose from";

export function StrengthPictures({ preset, strengths }: { preset: PresetInForce; strengths: Strengths | null }) {
  const link = useLink();
  const isOpen = strengths?.preset === preset.name;
  // One button for both, so that the keyboard stays on it.
  return (
    <>
      <Button
        label={isOpen ? "Close the pictures" : "Compare strengths"}
        hint={isOpen ? undefined : kHint}
        disabled={!isOpen && !(preset.strength > 0)}
        onClick={() => link.send(isOpen ? command.closeStrengths() : command.openStrengths())}
      />
      {isOpen && <Strip preset={preset} strengths={strengths} />}
    </>
  );
}

/** The pictures go with this part of the page. */
function Strip({ preset, strengths }: { preset: PresetInForce; strengths: Strengths }) {
  const link = useLink();
  useEffect(() => () => link.send(command.closeStrengths()), []);
  return (
    <>
      <div role="group" aria-label="Pictures of strengths" class="strengths">
        {strengths.pictures.map((picture, number) => (
          <Picture
            key={number}
            picture={picture}
            isInForce={Math.abs(picture.strength - preset.strength) < kSame}
            onChoose={() => link.send(command.chooseStrength(number))}
          />
        ))}
      </div>
      <div class="faint" role="status">
        {strengths.trial}
      </div>
    </>
  );
}

function Picture(props: { picture: StrengthPicture; isInForce: boolean; onChoose: () => void }) {
  const { strength, word, number } = props.picture;
  const address = useLink().strengthPicture(number);
  return (
    <button
      type="button"
      aria-label={`Strength ${fixed(2)(strength)}, ${word} of the preset`}
      title={`${word} of the preset`}
      aria-pressed={props.isInForce}
      aria-busy={!address}
      onClick={props.onChoose}
    >
      {address ? <img src={address} alt="" /> : <span class="no-picture" />}
      <span>{fixed(2)(strength)}</span>
    </button>
  );
}
