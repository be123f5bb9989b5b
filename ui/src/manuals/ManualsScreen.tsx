import { ArrowLeft, BookText } from "lucide-preact";
import { language, texts } from "../i18n";
import { languageRow } from "../i18n/languages";
import { Button } from "../kit/Button";
import { LinkButton } from "../kit/LinkButton";
import { Loaded } from "../kit/requests/Loaded";
import { manualsOrigin } from "../shell/help";
import { hashOf, type ParametersOf } from "../shell/route";
import { chosenLanguage, MANUAL_LANGUAGES, manualLanguage, useManuals } from "./library";
import { ManualArticle } from "./ManualArticle";
import { ManualList } from "./ManualList";

/** The manuals: their list with a search, or one of them. */
export function ManualsScreen({ manual: name, section }: ParametersOf<"manuals">) {
  return (
    <Loaded of={useManuals()} as="screen">
      {(manuals) => {
        const manual = manuals.find((one) => one.name === name);
        return (
          <main class="screen manuals" data-testid="manuals">
            <div class="manuals__head row middle gap-3">
              <BackLink />
              {manual && <AllManuals />}
              <OtherLanguage />
            </div>
            {manual ? (
              <ManualArticle key={manual.name} manual={manual} section={section} />
            ) : (
              <ManualList manuals={manuals} />
            )}
          </main>
        );
      }}
    </Loaded>
  );
}

/** Link to the screen from which the manuals were opened. */
function BackLink() {
  const { value: origin } = manualsOrigin;
  return (
    <LinkButton kind="plain" icon={ArrowLeft} href={hashOf(origin)} testId="manuals-back">
      {texts.value.titles[origin.screen]}
    </LinkButton>
  );
}

function AllManuals() {
  return (
    <LinkButton
      kind="plain"
      icon={BookText}
      href={hashOf({ screen: "manuals", manual: null, section: null })}
      testId="manuals-all"
    >
      {texts.value.titles.manuals}
    </LinkButton>
  );
}

/** Says that the manuals do not exist in the language of the page, and offers the languages in which they do. */
function OtherLanguage() {
  const shown = manualLanguage();
  if (shown === language.value) return null;
  const name = (one: typeof shown) => languageRow(one).name;
  return (
    <p class="manuals__language row middle gap-2" role="status">
      {texts.value.help.manuals.otherLanguage({ language: name(shown) })}
      {MANUAL_LANGUAGES.filter((one) => one !== shown).map((one) => (
        <Button
          key={one}
          lang={one}
          testId="manuals-language"
          onPress={() => {
            chosenLanguage.value = one;
          }}
        >
          {name(one)}
        </Button>
      ))}
    </p>
  );
}
