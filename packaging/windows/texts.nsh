; The installer's own texts; makensis refuses one that a language lacks.

LangString CONSOLE_NAME ${LANG_PORTUGUESEBR} "PINEL no terminal"
LangString CONSOLE_NAME ${LANG_ENGLISH} "PINEL in the terminal"
LangString CONSOLE_NAME ${LANG_SPANISH} "PINEL en la terminal"
LangString CONSOLE_NAME ${LANG_FRENCH} "PINEL dans le terminal"

LangString FILE_TYPE_NAME ${LANG_PORTUGUESEBR} "Trabalho do PINEL"
LangString FILE_TYPE_NAME ${LANG_ENGLISH} "PINEL work"
LangString FILE_TYPE_NAME ${LANG_SPANISH} "Trabajo de PINEL"
LangString FILE_TYPE_NAME ${LANG_FRENCH} "Travail de PINEL"

LangString OLD_WINDOWS ${LANG_PORTUGUESEBR} "O PINEL precisa do Windows 10 ou de um mais novo. Nada foi instalado."
LangString OLD_WINDOWS ${LANG_ENGLISH} "PINEL needs Windows 10 or a newer one. Nothing was installed."
LangString OLD_WINDOWS ${LANG_SPANISH} "PINEL necesita Windows 10 o uno más nuevo. No se instaló nada."
LangString OLD_WINDOWS ${LANG_FRENCH} "PINEL a besoin de Windows 10 ou d'une version plus récente. Rien n'a été installé."

LangString NO_RIGHTS ${LANG_PORTUGUESEBR} "Para todas as contas é preciso ser administrador. Use uma conta de administrador, ou /CurrentUser para instalar só nesta conta. Nada foi mudado."
LangString NO_RIGHTS ${LANG_ENGLISH} "All accounts need the administrator. Use an administrator's account, or /CurrentUser for this account only. Nothing was changed."
LangString NO_RIGHTS ${LANG_SPANISH} "Para todas las cuentas hace falta ser administrador. Use una cuenta de administrador, o /CurrentUser solo para esta cuenta. No se cambió nada."
LangString NO_RIGHTS ${LANG_FRENCH} "Pour tous les comptes, il faut être administrateur. Utilisez un compte d'administrateur, ou /CurrentUser pour ce compte seulement. Rien n'a été changé."

LangString IS_OPEN ${LANG_PORTUGUESEBR} "O PINEL está aberto. Feche-o, também nas outras contas deste computador, e tente de novo. Nada foi mudado."
LangString IS_OPEN ${LANG_ENGLISH} "PINEL is open. Close it, in the other accounts of this PC too, and try again. Nothing was changed."
LangString IS_OPEN ${LANG_SPANISH} "PINEL está abierto. Ciérrelo, también en las otras cuentas de esta computadora, e intente de nuevo. No se cambió nada."
LangString IS_OPEN ${LANG_FRENCH} "PINEL est ouvert. Fermez-le, aussi dans les autres comptes de cet ordinateur, et recommencez. Rien n'a été changé."

LangString NEWER ${LANG_PORTUGUESEBR} "Neste computador já está o PINEL $FormerVersion, mais novo que ${VERSION}. O trabalho feito com ele pode não abrir em um mais antigo. Nada foi mudado."
LangString NEWER ${LANG_ENGLISH} "This PC already has PINEL $FormerVersion, newer than ${VERSION}. Work done with it may not open in an older one. Nothing was changed."
LangString NEWER ${LANG_SPANISH} "Esta computadora ya tiene PINEL $FormerVersion, más nuevo que ${VERSION}. El trabajo hecho con él puede no abrirse en uno más antiguo. No se cambió nada."
LangString NEWER ${LANG_FRENCH} "Cet ordinateur a déjà PINEL $FormerVersion, plus récent que ${VERSION}. Le travail fait avec lui peut ne pas s'ouvrir dans une version plus ancienne. Rien n'a été changé."

LangString INSTALLING_WEBVIEW2 ${LANG_PORTUGUESEBR} "Instalando o WebView2, que mostra a janela…"
LangString INSTALLING_WEBVIEW2 ${LANG_ENGLISH} "Installing WebView2, which shows the window…"
LangString INSTALLING_WEBVIEW2 ${LANG_SPANISH} "Instalando WebView2, que muestra la ventana…"
LangString INSTALLING_WEBVIEW2 ${LANG_FRENCH} "Installation de WebView2, qui affiche la fenêtre…"

LangString NO_WEBVIEW2 ${LANG_PORTUGUESEBR} "O PINEL está instalado, mas este computador não tem o WebView2, que mostra a janela. Enquanto isso, ele abre no navegador. Para instalar sem internet, ponha ${WEBVIEW2_SETUP} ao lado deste instalador e instale de novo."
LangString NO_WEBVIEW2 ${LANG_ENGLISH} "PINEL is installed, but this PC has no WebView2, which shows the window. Meanwhile it opens in the browser. To install it without internet, put ${WEBVIEW2_SETUP} beside this installer and install again."
LangString NO_WEBVIEW2 ${LANG_SPANISH} "PINEL está instalado, pero esta computadora no tiene WebView2, que muestra la ventana. Mientras tanto, se abre en el navegador. Para instalarlo sin internet, ponga ${WEBVIEW2_SETUP} junto a este instalador e instale de nuevo."
LangString NO_WEBVIEW2 ${LANG_FRENCH} "PINEL est installé, mais cet ordinateur n'a pas WebView2, qui affiche la fenêtre. En attendant, il s'ouvre dans le navigateur. Pour l'installer sans internet, mettez ${WEBVIEW2_SETUP} à côté de cet installateur et recommencez."

LangString SETUP_FILE_FAULTS ${LANG_PORTUGUESEBR} "O PINEL está instalado, mas o arquivo pinel.toml tem erros. Para ver as linhas, digite no terminal do PINEL: pinel setup --check pinel.toml. Corrija-o e instale de novo."
LangString SETUP_FILE_FAULTS ${LANG_ENGLISH} "PINEL is installed, but the file pinel.toml has errors. To see the lines, type in PINEL's terminal: pinel setup --check pinel.toml. Correct it and install again."
LangString SETUP_FILE_FAULTS ${LANG_SPANISH} "PINEL está instalado, pero el archivo pinel.toml tiene errores. Para ver las líneas, escriba en la terminal de PINEL: pinel setup --check pinel.toml. Corríjalo e instale de nuevo."
LangString SETUP_FILE_FAULTS ${LANG_FRENCH} "PINEL est installé, mais le fichier pinel.toml a des erreurs. Pour voir les lignes, tapez dans le terminal de PINEL : pinel setup --check pinel.toml. Corrigez-le et recommencez."

LangString WORK_STAYS ${LANG_PORTUGUESEBR} "O PINEL saiu deste computador. O trabalho dos grupos continua na pasta AppData\Local\pinel de cada conta; a desta é $LOCALAPPDATA\pinel."
LangString WORK_STAYS ${LANG_ENGLISH} "PINEL was removed. The work of the groups stays in the folder AppData\Local\pinel of each account; this one's is $LOCALAPPDATA\pinel."
LangString WORK_STAYS ${LANG_SPANISH} "PINEL se desinstaló. El trabajo de los grupos sigue en la carpeta AppData\Local\pinel de cada cuenta; la de esta es $LOCALAPPDATA\pinel."
LangString WORK_STAYS ${LANG_FRENCH} "PINEL a été désinstallé. Le travail des groupes reste dans le dossier AppData\Local\pinel de chaque compte ; celui-ci a $LOCALAPPDATA\pinel."
