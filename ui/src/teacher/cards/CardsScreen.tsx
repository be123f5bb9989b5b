import { type Signal, useSignal } from "@preact/signals";
import { ArrowLeft, Printer, Save } from "lucide-preact";
import { useRef } from "preact/hooks";
import { texts } from "../../i18n";
import { Button } from "../../kit/Button";
import { LinkButton } from "../../kit/LinkButton";
import { RadioGroup } from "../../kit/RadioGroup";
import { Select } from "../../kit/Select";
import { usePrintedPage } from "../../shell/files/printed_page";
import { canPrint, printPage } from "../../shell/files/printing";
import { hashOf } from "../../shell/route";
import { savePage } from "../plan/page_file";
import { CardSheet } from "./CardSheet";
import { CARD_LISTS, type CardList } from "./card_lists";

const COPIES = [1, 2, 3, 4, 6, 8] as const;

type Ink = "lines" | "colours";

/** Cards of blocks to cut out, as the print shows them. */
export function CardsScreen() {
  const { plan } = texts.value;
  const labels = plan.cards;
  const list = useSignal<CardList>("lesson");
  const copies = useSignal(4);
  const ink = useSignal<Ink>("lines");
  const sheet = useRef<HTMLElement>(null);
  usePrintedPage("cards");
  return (
    <main class="screen cards-screen">
      <div class="review-head cards-screen__head row middle gap-4">
        <LinkButton
          icon={ArrowLeft}
          label={labels.back}
          href={hashOf({ screen: "teacher", part: "plan" })}
        />
        <h1>{labels.title}</h1>
        <p>{labels.about}</p>
        {canPrint() && (
          <Button kind="main" icon={Printer} testId="cards-print" onPress={printPage}>
            {plan.print}
          </Button>
        )}
        <Button
          icon={Save}
          tip={plan.saveHelp}
          testId="cards-save"
          onPress={() => savePage(sheet.current, labels.title, labels.fileName)}
        >
          {plan.save}
        </Button>
      </div>
      <CardOptions list={list} copies={copies} ink={ink} />
      <CardSheet list={list.value} copies={copies.value} ink={ink.value} elementRef={sheet} />
    </main>
  );
}

interface CardOptionsProps {
  list: Signal<CardList>;
  copies: Signal<number>;
  ink: Signal<Ink>;
}

/** Selects the cards, the number of copies, and the ink. */
function CardOptions({ list, copies, ink }: CardOptionsProps) {
  const labels = texts.value.plan.cards;
  return (
    <div class="cards-screen__options">
      <label class="filters__one">
        <span>{labels.which}</span>
        <Select<CardList>
          value={list.value}
          options={CARD_LISTS.map((name) => [name, labels.lists[name]])}
          testId="cards-list"
          onChange={(chosen) => {
            list.value = chosen;
          }}
        />
      </label>
      <label class="filters__one">
        <span>{labels.copies}</span>
        <Select<number>
          value={copies.value}
          options={COPIES.map((n) => [n, String(n)])}
          testId="cards-copies"
          onChange={(chosen) => {
            copies.value = Number(chosen);
          }}
        />
      </label>
      <RadioGroup<Ink>
        class="switch row middle shrinks"
        label={labels.ink}
        legendClass="switch__word"
        optionClass=""
        testId="cards-ink"
        value={ink.value}
        options={[
          ["lines", labels.inks.lines],
          ["colours", labels.inks.colours],
        ]}
        onChange={(chosen) => {
          ink.value = chosen;
        }}
      />
      <p>{labels.printHelp}</p>
    </div>
  );
}
